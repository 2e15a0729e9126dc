# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Source files of one folder are compiled several at a time: what every file
# reads again costs more than what stands in it, and a first build takes a third
# of the time (doc/development.md). Names in anonymous namespaces must therefore
# differ within a folder. With SQUEAL_JOINED_UNITS off every file is a unit,
# which is quicker for who changes one file over and over.

option(SQUEAL_JOINED_UNITS "Compile several source files of a folder at a time" ON)
set(SQUEAL_FILES_OF_A_UNIT 12)

# squeal_join_units(target): groups of neighbours in the sorted list of a folder,
# so that a new file moves the groups of its own folder alone.
function(squeal_join_units target)
  if(NOT SQUEAL_JOINED_UNITS)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(_sources ${target} SOURCES)
  foreach(_source IN LISTS _sources)
    get_filename_component(_folder "${_source}" DIRECTORY)
    string(MAKE_C_IDENTIFIER "${_folder}" _folder)
    if(NOT DEFINED _files_${_folder})
      set(_files_${_folder} 0)
    endif()
    math(EXPR _group "${_files_${_folder}} / ${SQUEAL_FILES_OF_A_UNIT}")
    math(EXPR _files_${_folder} "${_files_${_folder}} + 1")
    set_source_files_properties("${_source}" PROPERTIES UNITY_GROUP ${_folder}_${_group})
  endforeach()
endfunction()
