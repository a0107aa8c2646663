# Run the scenes in space and let ParaView's reader check their files
# (read_in_space.py).
if(NOT PVPYTHON)
  message(FATAL_ERROR "pvpython is missing; install the package paraview.")
endif()
file(GLOB _scenes ${SOURCE_DIR}/prm/space/*.prm)
set(_directories)
foreach(_scene ${_scenes})
  get_filename_component(_name ${_scene} NAME_WE)
  execute_process(
    COMMAND ${VOUSSOIR} ${_scene} --set "Output directory=space_${_name}"
    RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "voussoir ended with status ${status} on ${_scene}")
  endif()
  list(APPEND _directories space_${_name})
endforeach()
execute_process(
  COMMAND ${PVPYTHON} ${SOURCE_DIR}/tests/output/read_in_space.py
    ${_directories}
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the files are not as they should be")
endif()
