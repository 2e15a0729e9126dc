# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Writes include/squeal/base/version.h into the build directory. A commit
# triggers a new configuration, so the revision is never stale; the header is
# only touched when its text changes.

set(SQUEAL_REVISION "unknown")
find_package(Git QUIET)
if(Git_FOUND)
  execute_process(
    COMMAND "${GIT_EXECUTABLE}" rev-parse --short=10 HEAD
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    OUTPUT_VARIABLE _revision
    OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET
    RESULT_VARIABLE _status)
  if(_status EQUAL 0)
    set(SQUEAL_REVISION "${_revision}")
    execute_process(
      COMMAND "${GIT_EXECUTABLE}" rev-parse --git-path logs/HEAD
      WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
      OUTPUT_VARIABLE _log
      OUTPUT_STRIP_TRAILING_WHITESPACE
      ERROR_QUIET)
    get_filename_component(_log "${_log}" ABSOLUTE
                           BASE_DIR "${PROJECT_SOURCE_DIR}")
    if(EXISTS "${_log}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${_log}")
    endif()
  endif()
endif()

file(STRINGS "${MUMPS_INCLUDE_DIR}/dmumps_c.h" _line
     REGEX "#define MUMPS_VERSION +\"")
string(REGEX REPLACE ".*\"([0-9.]+)\".*" "\\1" SQUEAL_MUMPS_VERSION "${_line}")

find_package(arpack-ng QUIET CONFIG)
set(SQUEAL_ARPACK_VERSION "${arpack-ng_VERSION}")
if(NOT SQUEAL_ARPACK_VERSION)
  set(SQUEAL_ARPACK_VERSION "unknown")
endif()

configure_file("${PROJECT_SOURCE_DIR}/cmake/version.h.in"
               "${PROJECT_BINARY_DIR}/include/squeal/base/version.h" @ONLY)
