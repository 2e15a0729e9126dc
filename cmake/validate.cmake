# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -DPRM=directory -DPROGRAM=squeal [-DTRIBOLOGY=squeal-tribology]
#       -P validate.cmake
#
# Lets the program of its analysis check every parameter file below PRM; fails
# when one of them is refused. Files of an absent program are left out, by name.

cmake_minimum_required(VERSION 3.20)

# Adds the number of files in the list FILES that PROGRAM refuses to _refused.
# One start checks them all, as a start takes longer than a check. It ends with
# the first file that is refused; the next one goes on behind it.
function(_validate program files)
  while(files)
    execute_process(COMMAND "${program}" --validate ${files}
                    OUTPUT_VARIABLE _output ERROR_VARIABLE _errors
                    RESULT_VARIABLE _status)
    set(_valid "")
    string(REPLACE "\n" ";" _lines "${_output}")
    foreach(_file IN LISTS files)
      if(NOT "${_file}: valid" IN_LIST _lines)
        break()
      endif()
      message(STATUS "ok       ${_file}")
      list(APPEND _valid "${_file}")
    endforeach()
    list(REMOVE_ITEM files ${_valid})
    if(files)
      list(POP_FRONT files _file)
      message(STATUS "REFUSED  ${_file}\n${_errors}")
      math(EXPR _refused "${_refused} + 1")
    elseif(NOT _status EQUAL 0)
      message(STATUS "REFUSED  ${_status}\n${_errors}")
      math(EXPR _refused "${_refused} + 1")
    endif()
  endwhile()
  set(_refused ${_refused} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE _files "${PRM}/*.prm")
list(SORT _files)
if(NOT _files)
  message(FATAL_ERROR "no parameter files in ${PRM}")
endif()
set(_of_squeal "")
set(_of_tribology "")
foreach(_file IN LISTS _files)
  file(STRINGS "${_file}" _tribology
       REGEX "^ *set +Analysis *= *(damage|segmentation|correlation|synthetic specimen|recorded history)")
  if(NOT _tribology)
    list(APPEND _of_squeal "${_file}")
  elseif(TRIBOLOGY)
    list(APPEND _of_tribology "${_file}")
  else()
    message(STATUS "left out ${_file}")
  endif()
endforeach()
set(_refused 0)
_validate("${PROGRAM}" "${_of_squeal}")
_validate("${TRIBOLOGY}" "${_of_tribology}")
if(_refused)
  message(FATAL_ERROR "${_refused} parameter files were refused")
endif()
