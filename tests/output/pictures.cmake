# Render every view of every scene in one pvbatch, and judge the pictures
# (check_pictures.py).
find_program(XVFB_RUN xvfb-run)
find_program(PVBATCH pvbatch)
if(NOT XVFB_RUN OR NOT PVBATCH)
  message(FATAL_ERROR
    "xvfb-run or pvbatch is missing; install the packages xvfb, xauth and paraview.")
endif()
execute_process(
  COMMAND ${XVFB_RUN} -a ${PVBATCH}
    ${SOURCE_DIR}/tests/output/check_pictures.py ${VOUSSOIR} ${SOURCE_DIR}
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the pictures are not as they should be")
endif()
