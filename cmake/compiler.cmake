# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Compiler settings that hold for all of our own code.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")

# A switch over an enum names every enumerator: a new one does not compile until
# every place that computes by it says what it does. The option changes no
# object file: ccache need not tell results by it.
set(SQUEAL_ERRORS -Werror=switch)

# The compiler's own memory is cleaned up less often: a twentieth of a first
# build, for 150 MB more a process. No object file changes by it either.
set(SQUEAL_COMPILER_MEMORY --param=ggc-min-expand=400)
add_compile_options(
  "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:${SQUEAL_COMPILER_MEMORY}>")

find_program(SQUEAL_CCACHE ccache)
mark_as_advanced(SQUEAL_CCACHE)
if(SQUEAL_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  # Names relative to the source tree, so that another clone finds the same
  # results; the sloppiness is what ccache asks for with precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}"
      CCACHE_NOHASHDIR=1 "CCACHE_IGNOREOPTIONS=${SQUEAL_ERRORS} ${SQUEAL_COMPILER_MEMORY}"
      "CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime"
      "${SQUEAL_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${CMAKE_CXX_COMPILER_LAUNCHER}")
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>)
endif()

# Optimisation is set here, once, instead of by deal.II's flags: those add -g
# to Release too, which doubles compile and link times.
set(SQUEAL_FLAGS_RELEASE -O3 -funroll-loops)
set(SQUEAL_FLAGS_DEBUG -Og -g1 -D_GLIBCXX_ASSERTIONS)

# A hundred test programs are linked against deal.II, whose symbols the usual
# linker takes two to four seconds to read: mold takes half of that.
find_program(SQUEAL_MOLD mold)
mark_as_advanced(SQUEAL_MOLD)
if(SQUEAL_MOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU"
   AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12.1)
  set(SQUEAL_MOLD SQUEAL_MOLD-NOTFOUND)
endif()

# The first fault ends the program. Run-time type checks are left out: they ask
# for type information that the libraries keep to themselves.
if(SQUEAL_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=vptr
                      -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
