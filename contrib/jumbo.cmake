# Most of the time of compiling a file goes into the headers of deal.II. A jumbo
# file includes up to VOUSSOIR_JUMBO_SIZE source files of one folder, which have to
# differ in the names of their unnamed namespaces. It pays where all is built from
# nothing; who changes single files does without.

set(VOUSSOIR_JUMBO_SIZE 10 CACHE STRING "The most files that are compiled as one")
mark_as_advanced(VOUSSOIR_JUMBO_SIZE)

# Compile the sources of a target, as they are listed so far, in jumbo files.
function(voussoir_jumbo _target)
  set_target_properties(${_target} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(_sources ${_target} SOURCES)
  set(_folders)
  foreach(_source ${_sources})
    get_filename_component(_folder ${_source} ABSOLUTE)
    get_filename_component(_folder ${_folder} DIRECTORY)
    file(RELATIVE_PATH _folder ${CMAKE_SOURCE_DIR} ${_folder})
    string(MAKE_C_IDENTIFIER "${_folder}" _folder)
    list(APPEND _folders ${_folder})
    list(APPEND _files_of_${_folder} ${_source})
  endforeach()
  list(REMOVE_DUPLICATES _folders)
  foreach(_folder ${_folders})
    list(LENGTH _files_of_${_folder} _n)
    math(EXPR _n_groups
      "(${_n} + ${VOUSSOIR_JUMBO_SIZE} - 1) / ${VOUSSOIR_JUMBO_SIZE}")
    set(_k 0)
    foreach(_source ${_files_of_${_folder}})
      math(EXPR _group "${_k} * ${_n_groups} / ${_n}")
      math(EXPR _k "${_k} + 1")
      set_source_files_properties(${_source} PROPERTIES
        UNITY_GROUP ${_folder}_${_group})
    endforeach()
  endforeach()
endfunction()
