# Most of the time of compiling a file goes into reading the headers of deal.II.
# A jumbo file includes up to VOUSSOIR_JUMBO_SIZE source files of one folder,
# which have to differ in the names of their unnamed namespaces. It pays where all
# is built from nothing; who changes single files does without.

set(VOUSSOIR_JUMBO_SIZE 14 CACHE STRING "The most files that are compiled as one")
mark_as_advanced(VOUSSOIR_JUMBO_SIZE)

# Compile the sources of a target, as they are listed so far, in jumbo files.
function(voussoir_jumbo _target)
  set_target_properties(${_target} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(_sources ${_target} SOURCES)
  foreach(_source ${_sources})
    get_filename_component(_folder ${_source} DIRECTORY)
    string(MAKE_C_IDENTIFIER ${_folder} _folder)
    math(EXPR _group "0${_n_${_folder}} / ${VOUSSOIR_JUMBO_SIZE}")
    math(EXPR _n_${_folder} "0${_n_${_folder}} + 1")
    set_source_files_properties(${_source} PROPERTIES
      UNITY_GROUP ${_folder}_${_group})
  endforeach()
endfunction()
