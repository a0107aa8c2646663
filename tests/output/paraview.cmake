# Run a scene and let ParaView's reader check its files (read_with_paraview.py).
if(NOT PVPYTHON)
  message(FATAL_ERROR "pvpython is missing; install the package paraview.")
endif()
# Its own files, and those of the collapse that a lower strength leads to.
foreach(_run "paraview|10|0" "paraview_collapse|0.9|3")
  string(REPLACE "|" ";" _run ${_run})
  list(GET _run 0 _directory)
  list(GET _run 1 _strength)
  list(GET _run 2 _expected)
  execute_process(
    COMMAND ${VOUSSOIR} ${SOURCE_DIR}/prm/shear_wall.prm
      --set "Output directory=${_directory}"
      --set "Friction/Strength=${_strength}"
    RESULT_VARIABLE status)
  if(NOT status EQUAL ${_expected})
    message(FATAL_ERROR "voussoir ended with status ${status}")
  endif()
endforeach()
# A uniform stress with three components that differ.
execute_process(
  COMMAND ${VOUSSOIR} ${SOURCE_DIR}/prm/verification_1.prm
    --set "Output directory=paraview_uniform"
    --set "Formulation=least energy"
    --set "Loads/Boundary load=uniform stress"
    --set [[Loads/Stress=-1, 0.3; 0.3, -2]]
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "voussoir ended with status ${status}")
endif()
# Supports and groups.
execute_process(
  COMMAND ${VOUSSOIR} ${SOURCE_DIR}/prm/arch.prm
    --set "Output directory=paraview_arch"
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "voussoir ended with status ${status}")
endif()
# The same by three processes.
separate_arguments(MPIEXEC)
execute_process(
  COMMAND ${MPIEXEC} 3 ${VOUSSOIR} ${SOURCE_DIR}/prm/arch.prm
    --set "Output directory=paraview_arch_together"
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "voussoir on three processes ended with status ${status}")
endif()
# All values, and pieces.
execute_process(COMMAND ${WRITE_PIECES} paraview_pieces RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "write_pieces ended with status ${status}")
endif()
execute_process(
  COMMAND ${PVPYTHON} ${SOURCE_DIR}/tests/output/read_with_paraview.py
    paraview paraview_collapse paraview_uniform paraview_arch
    paraview_arch_together paraview_pieces
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the files are not as they should be")
endif()
