# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Compiler settings that hold for all of our own code.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")

find_program(SQUEAL_CCACHE ccache)
mark_as_advanced(SQUEAL_CCACHE)
if(SQUEAL_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER "${SQUEAL_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${SQUEAL_CCACHE}")
endif()

# Optimisation is set here, once, instead of by deal.II's flags: those add -g
# to Release too, which doubles compile and link times.
set(SQUEAL_FLAGS_RELEASE -O3 -funroll-loops)
set(SQUEAL_FLAGS_DEBUG -Og -g1 -D_GLIBCXX_ASSERTIONS)
