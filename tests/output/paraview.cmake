# Run a scene and let ParaView's reader check its files (read_with_paraview.py).
if(NOT PVPYTHON)
  message(FATAL_ERROR "pvpython is missing; install the package paraview.")
endif()
execute_process(
  COMMAND ${VOUSSOIR} ${SOURCE_DIR}/prm/shear_wall.prm
    --set "Output directory=paraview"
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "voussoir ended with status ${status}")
endif()
execute_process(
  COMMAND ${PVPYTHON} ${SOURCE_DIR}/tests/output/read_with_paraview.py paraview
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the files are not as they should be")
endif()
