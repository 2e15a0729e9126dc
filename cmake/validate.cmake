# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -DPRM=directory -DPROGRAM=squeal [-DTRIBOLOGY=squeal-tribology]
#       -P validate.cmake
#
# Lets the program of its analysis check every parameter file below PRM; fails
# when one of them is refused. Files of an absent program are left out, by name.

file(GLOB_RECURSE _files "${PRM}/*.prm")
list(SORT _files)
if(NOT _files)
  message(FATAL_ERROR "no parameter files in ${PRM}")
endif()
set(_refused 0)
foreach(_file IN LISTS _files)
  file(STRINGS "${_file}" _tribology
       REGEX "^ *set +Analysis *= *(damage|segmentation|correlation|synthetic specimen|recorded history)")
  set(_program "${PROGRAM}")
  if(_tribology)
    set(_program "${TRIBOLOGY}")
  endif()
  if(NOT _program)
    message(STATUS "left out ${_file}")
    continue()
  endif()
  execute_process(COMMAND "${_program}" --validate "${_file}"
                  OUTPUT_VARIABLE _output ERROR_VARIABLE _output
                  RESULT_VARIABLE _status)
  if(_status EQUAL 0)
    message(STATUS "ok       ${_file}")
  else()
    message(STATUS "REFUSED  ${_file}\n${_output}")
    math(EXPR _refused "${_refused} + 1")
  endif()
endforeach()
if(_refused)
  message(FATAL_ERROR "${_refused} parameter files were refused")
endif()
