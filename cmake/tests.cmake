# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Functions that declare tests. Labels: "debug" builds and runs the test in the
# Debug configuration too, "long" keeps it out of the default run.

# Threads never multiply with ranks or with tests that run side by side, and
# ranks of two tests are not bound to the same core.
set(SQUEAL_TEST_ENVIRONMENT
    OMP_NUM_THREADS=1
    OPENBLAS_NUM_THREADS=1
    DEAL_II_NUM_THREADS=1
    OMPI_ALLOW_RUN_AS_ROOT=1
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    OMPI_MCA_ess_singleton_isolated=1
    OMPI_MCA_btl_vader_single_copy_mechanism=none
    OMPI_MCA_hwloc_base_binding_policy=none
    OMPI_MCA_rmaps_base_oversubscribe=1)

# The kernels that squeal takes, see include/squeal/base/blas_kernels.h: the test
# programs work with them too, and a program that finds them set does not load
# its libraries a second time, 0.4 s a start. Only where our own code needs this
# machine's processor as well.
if(SQUEAL_NATIVE AND EXISTS /proc/cpuinfo)
  file(STRINGS /proc/cpuinfo _flags REGEX "^flags" LIMIT_COUNT 1)
  string(REGEX REPLACE "[ \t:]+" ";" _flags "${_flags}")
  set(_kernels "")
  foreach(_set "Haswell avx2 fma"
               "SkylakeX avx512f avx512dq avx512cd avx512bw avx512vl")
    string(REPLACE " " ";" _needed "${_set}")
    list(POP_FRONT _needed _name)
    list(REMOVE_ITEM _needed ${_flags})
    if(NOT _needed)
      set(_kernels ${_name})
    endif()
  endforeach()
  if(_kernels)
    list(APPEND SQUEAL_TEST_ENVIRONMENT OPENBLAS_CORETYPE=${_kernels})
  endif()
endif()

set(SQUEAL_DEFAULT_TIMEOUT 120)
if(SQUEAL_SANITIZE)
  list(APPEND SQUEAL_TEST_ENVIRONMENT
       ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1
       UBSAN_OPTIONS=print_stacktrace=1
       LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/sanitizers/leaks.supp:print_suppressions=0
  )
  set(SQUEAL_DEFAULT_TIMEOUT 600)
endif()

# In a header, not on the command line of every test, which would compile anew
# in another clone.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/tests/source_directory.h" CONTENT
     "#define SQUEAL_SOURCE_DIR \"${PROJECT_SOURCE_DIR}\"\n")

# Sets ${variable} to the command that starts a program on ${n} ranks.
function(_squeal_launcher variable n)
  if(n GREATER 1)
    set(${variable} "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} ${n}
        PARENT_SCOPE)
  else()
    set(${variable} "" PARENT_SCOPE)
  endif()
endfunction()

function(_squeal_test_properties name ranks timeout)
  if(NOT ranks)
    set(ranks 1)
  endif()
  if(NOT timeout)
    set(timeout ${SQUEAL_DEFAULT_TIMEOUT})
  endif()
  set_tests_properties(
    ${name} PROPERTIES PROCESSORS ${ranks} TIMEOUT ${timeout}
                       ENVIRONMENT "${SQUEAL_TEST_ENVIRONMENT}"
                       LABELS "${ARGN}")
endfunction()

# squeal_add_main(program source libraries...): an object with the main function
# of a program under the name of main_of_<program>().
function(squeal_add_main program source)
  add_library(main_of_${program} OBJECT EXCLUDE_FROM_ALL "${source}")
  target_compile_definitions(main_of_${program}
                             PRIVATE main=main_of_${program})
  target_link_libraries(main_of_${program} ${ARGN})
  squeal_setup_target(main_of_${program})
endfunction()

# squeal_add_test(name source [MPI n] [LABELS ...] [TIMEOUT seconds]
#                 [ARGUMENTS ...] [AFTER test...] [LIBRARIES ...]
#                 [PROGRAMS squeal squeal_tribology])
#
# A test program: exit code 0 is a pass. It is linked against squeal_core and
# LIBRARIES, finds the source tree by source_directory.h and runs in a
# directory of its own, ${CMAKE_BINARY_DIR}/tests/run/<name>. One source may
# serve several tests (other ranks or arguments). AFTER names tests whose files
# it needs. PROGRAMS are those whose main function is linked into it by the name
# of main_of_<program>(), for run_program() of tests/analyses/program.h.
function(squeal_add_test name source)
  cmake_parse_arguments(PARSE_ARGV 2 test "" "MPI;TIMEOUT"
                        "LABELS;ARGUMENTS;AFTER;LIBRARIES;PROGRAMS")
  if(test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "squeal_add_test(${name}): unknown argument "
                        "'${test_UNPARSED_ARGUMENTS}'")
  endif()
  if(CMAKE_BUILD_TYPE STREQUAL "Debug" AND NOT "debug" IN_LIST test_LABELS)
    return()
  endif()
  get_filename_component(_source "${source}" ABSOLUTE)
  string(REGEX REPLACE "[/.]" "_" _target "test_${source}")
  string(REGEX REPLACE "_cc$" "" _target "${_target}")
  if(NOT TARGET ${_target})
    add_executable(${_target} "${_source}")
    target_include_directories(${_target}
                               PRIVATE "${PROJECT_SOURCE_DIR}/tests"
                                       "${PROJECT_BINARY_DIR}/tests")
    foreach(_program ${test_PROGRAMS})
      target_link_libraries(${_target} $<TARGET_OBJECTS:main_of_${_program}>)
    endforeach()
    target_link_libraries(${_target} squeal_core ${test_LIBRARIES})
    squeal_setup_target(${_target})
    squeal_share_precompiled(${_target} squeal_core)
    set_target_properties(
      ${_target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY
                            "${PROJECT_BINARY_DIR}/tests/programs")
    add_dependencies(squeal_tests ${_target})
  endif()
  set(_directory "${PROJECT_BINARY_DIR}/tests/run/${name}")
  file(MAKE_DIRECTORY "${_directory}")
  _squeal_launcher(_launcher "${test_MPI}")
  add_test(NAME ${name}
           COMMAND ${_launcher} $<TARGET_FILE:${_target}> ${test_ARGUMENTS}
           WORKING_DIRECTORY "${_directory}")
  _squeal_test_properties(${name} "${test_MPI}" "${test_TIMEOUT}"
                          ${test_LABELS})
  # Tests side by side must not remove each other's files of Open MPI.
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT
                                  "OMPI_MCA_orte_tmpdir_base=${_directory}")
  if(test_AFTER)
    set_tests_properties(${name} PROPERTIES DEPENDS "${test_AFTER}")
  endif()
endfunction()

# squeal_add_prm_test(name file.prm [MPI n] [LABELS ...] [TIMEOUT seconds])
#
# Runs squeal on a parameter file whose result checks decide: exit code 0 is a
# pass. Relative names start at the top of the source tree.
function(squeal_add_prm_test name file)
  cmake_parse_arguments(PARSE_ARGV 2 test "" "MPI;TIMEOUT" "LABELS")
  if(test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "squeal_add_prm_test(${name}): unknown argument "
                        "'${test_UNPARSED_ARGUMENTS}'")
  endif()
  if(CMAKE_BUILD_TYPE STREQUAL "Debug" AND NOT "debug" IN_LIST test_LABELS)
    return()
  endif()
  get_filename_component(_file "${file}" ABSOLUTE
                         BASE_DIR "${PROJECT_SOURCE_DIR}")
  if(NOT EXISTS "${_file}")
    message(FATAL_ERROR "squeal_add_prm_test(${name}): no file ${_file}")
  endif()
  set(_settings
      --set "Output directory = ${PROJECT_BINARY_DIR}/tests/run/${name}" --set
      "Overwrite = true")
  add_dependencies(squeal_tests squeal)
  _squeal_launcher(_launcher "${test_MPI}")
  add_test(NAME ${name}
           COMMAND ${_launcher} $<TARGET_FILE:squeal> "${_file}" ${_settings}
           WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  _squeal_test_properties(${name} "${test_MPI}" "${test_TIMEOUT}"
                          ${test_LABELS})
endfunction()

# squeal_add_validate_test(): every shipped parameter file is accepted as it is.
function(squeal_add_validate_test)
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    return()
  endif()
  set(_tribology "")
  if(TARGET squeal-tribology)
    set(_tribology "-DTRIBOLOGY=$<TARGET_FILE:squeal-tribology>")
  endif()
  add_test(NAME parameters.every_shipped_file_is_valid
           COMMAND "${CMAKE_COMMAND}" "-DPRM=${PROJECT_SOURCE_DIR}/prm"
                   "-DPROGRAM=$<TARGET_FILE:squeal>" ${_tribology} -P
                   "${PROJECT_SOURCE_DIR}/cmake/validate.cmake"
           WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  _squeal_test_properties(parameters.every_shipped_file_is_valid 1 300)
endfunction()
