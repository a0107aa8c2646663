# That a page of the manual is what the program prints.
get_filename_component(written ${PAGE} NAME)
execute_process(COMMAND ${VOUSSOIR} --print-reference ${OPTIONS}
  OUTPUT_FILE ${written} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "voussoir ended with status ${status}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${written} ${PAGE}
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PAGE} is out of date; write it again by "
    "contrib/run --print-reference ${OPTIONS} > ${PAGE}")
endif()
