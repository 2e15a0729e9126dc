# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Finds the libraries and defines squeal_setup_target(target), which every
# library, executable and test of the project calls.

find_package(Threads REQUIRED)
find_package(MPI REQUIRED COMPONENTS C)
find_package(deal.II 9.4 REQUIRED QUIET)
foreach(_feature MPI P4EST TRILINOS MUPARSER LAPACK)
  if(NOT DEAL_II_WITH_${_feature})
    message(FATAL_ERROR "deal.II in ${DEAL_II_PATH} was built without "
                        "${_feature}, which squeal needs.")
  endif()
endforeach()

# The reference BLAS makes factorisations three times slower.
set(BLA_VENDOR OpenBLAS)
find_package(BLAS QUIET)
find_package(LAPACK QUIET)
if(NOT BLAS_FOUND OR NOT LAPACK_FOUND)
  message(FATAL_ERROR "OpenBLAS was not found: "
                      "apt-get install libopenblas-pthread-dev")
endif()

# The parallel library, as deal.II links it: the serial one in the same program
# would answer half of the calls.
set(HDF5_PREFER_PARALLEL TRUE)
find_package(HDF5 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "HDF5 with MPI was not found: "
                      "apt-get install libhdf5-mpi-dev")
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE QUIET)
find_package(nlohmann_json 3.7 REQUIRED QUIET)

find_path(MUMPS_INCLUDE_DIR dmumps_c.h REQUIRED)
find_library(DMUMPS_LIBRARY dmumps REQUIRED)
find_library(ZMUMPS_LIBRARY zmumps REQUIRED)
find_library(MUMPS_COMMON_LIBRARY mumps_common REQUIRED)
find_path(ARPACK_INCLUDE_DIR arpack.h PATH_SUFFIXES arpack arpack-ng REQUIRED)
find_library(ARPACK_LIBRARY arpack REQUIRED)
find_library(PARPACK_LIBRARY parpack REQUIRED)
find_path(NLOPT_INCLUDE_DIR nlopt.h)
find_library(NLOPT_LIBRARY nlopt)
if(NOT NLOPT_INCLUDE_DIR OR NOT NLOPT_LIBRARY)
  message(FATAL_ERROR "NLopt was not found: apt-get install libnlopt-dev")
endif()
# Read at run time; reports show still pictures without it.
find_file(SQUEAL_THREE_JS three.min.js
          PATHS /usr/share/javascript/three /usr/share/nodejs/three/build)
if(NOT SQUEAL_THREE_JS)
  message(WARNING "three.js was not found, reports will not move: "
                  "apt-get install libjs-three")
  set(SQUEAL_THREE_JS "")
endif()
mark_as_advanced(SQUEAL_THREE_JS NLOPT_INCLUDE_DIR NLOPT_LIBRARY MUMPS_INCLUDE_DIR DMUMPS_LIBRARY ZMUMPS_LIBRARY
                 MUMPS_COMMON_LIBRARY ARPACK_INCLUDE_DIR ARPACK_LIBRARY
                 PARPACK_LIBRARY)

# deal.II hands its own optimisation flags on; ours replace them.
separate_arguments(_flags UNIX_COMMAND "${DEAL_II_CXX_FLAGS}")
list(FILTER _flags EXCLUDE REGEX
     "^-(g|ggdb|O.|pedantic|Wmissing-braces|std=.*|Wdate-time|D_FORTIFY_SOURCE=.*|f(stack-protector|file-prefix-map).*)$")
string(REPLACE ";" " " DEAL_II_CXX_FLAGS "${_flags}")
string(REPLACE ";" " " DEAL_II_CXX_FLAGS_RELEASE "${SQUEAL_FLAGS_RELEASE}")
string(REPLACE ";" " " DEAL_II_CXX_FLAGS_DEBUG "${SQUEAL_FLAGS_DEBUG}")

# -march=native is safe because no type that crosses a library boundary depends
# on it: deal.II's config.h fixes the width of VectorizedArray to none (with any
# other width deal.II brings its own processor flags and ours stay away), and
# Eigen types stay inside our own code, all of which is compiled alike. The
# processor is part of the command line, so that neither ccache nor a build
# directory carried to another machine serves code that it cannot run.
set(SQUEAL_FLAGS_NATIVE "")
if(SQUEAL_NATIVE)
  file(STRINGS "${DEAL_II_PATH}/include/deal.II/base/config.h" _width
       REGEX "define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 0$")
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-march=native SQUEAL_HAS_MARCH_NATIVE)
  if(_width AND SQUEAL_HAS_MARCH_NATIVE)
    set(_processor "${CMAKE_HOST_SYSTEM_PROCESSOR}")
    if(EXISTS /proc/cpuinfo)
      file(STRINGS /proc/cpuinfo _processor REGEX "^(flags|Features)"
           LIMIT_COUNT 1)
    endif()
    string(MD5 _processor "${_processor}")
    string(SUBSTRING "${_processor}" 0 8 _processor)
    # GCC 12 warns of its own AVX-512 intrinsics (GCC bug 105593), without
    # optimisation by another name; of our code the release build warns.
    set(SQUEAL_FLAGS_NATIVE -march=native -DSQUEAL_PROCESSOR=0x${_processor}
                            -Wno-maybe-uninitialized
                            $<$<CONFIG:DEBUG>:-Wno-uninitialized>)
  endif()
endif()

# OpenBLAS is named first and kept even where only MUMPS calls it, so that its
# symbols win over whatever libblas.so.3 the system's alternatives point to.
set(_openblas ${BLAS_LIBRARIES} ${LAPACK_LIBRARIES})
list(REMOVE_DUPLICATES _openblas)
list(FILTER _openblas INCLUDE REGEX "blas")

# The build's own headers come first, then the libraries as system headers.
function(squeal_setup_target target)
  target_link_libraries(
    ${target} -Wl,--no-as-needed ${_openblas} -Wl,--as-needed)
  target_include_directories(
    ${target} PRIVATE "${PROJECT_SOURCE_DIR}/include"
                      "${PROJECT_BINARY_DIR}/include")
  target_include_directories(
    ${target} SYSTEM PRIVATE ${MUMPS_INCLUDE_DIR} ${ARPACK_INCLUDE_DIR}
                             ${NLOPT_INCLUDE_DIR} ${HDF5_INCLUDE_DIRS})
  deal_ii_setup_target(${target})
  get_target_property(_type ${target} TYPE)
  if(SQUEAL_MOLD)
    # Behind deal.II's own choice of a linker: the last one counts.
    set_property(TARGET ${target} APPEND_STRING PROPERTY LINK_FLAGS
                                                         " -fuse-ld=mold")
  endif()
  if(SQUEAL_SANITIZE AND _type STREQUAL "EXECUTABLE")
    target_sources(${target}
                   PRIVATE "${PROJECT_SOURCE_DIR}/cmake/keep_modules.cc")
  endif()
  target_compile_options(
    ${target} PRIVATE ${SQUEAL_FLAGS_NATIVE}
                      $<$<COMPILE_LANGUAGE:CXX>:${SQUEAL_ERRORS}>)
  # The C++ bindings of MPI are gone from the standard and slow to compile.
  # Eigen hands large products to OpenBLAS. What links VTK gets TBB's debug
  # definition with it, and a precompiled header serves only units that have the
  # same definitions: all have it.
  target_compile_definitions(
    ${target} PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX EIGEN_USE_BLAS
                      $<$<CONFIG:DEBUG>:TBB_USE_DEBUG>)
  target_link_libraries(
    ${target} ${DMUMPS_LIBRARY} ${ZMUMPS_LIBRARY} ${MUMPS_COMMON_LIBRARY}
    ${PARPACK_LIBRARY} ${ARPACK_LIBRARY} ${NLOPT_LIBRARY} ${HDF5_C_LIBRARIES} Eigen3::Eigen
    nlohmann_json::nlohmann_json MPI::MPI_C Threads::Threads)
endfunction()
