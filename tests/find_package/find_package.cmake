# Install, build the project beside on what is installed, and run it.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/prefix)
set(build ${CMAKE_CURRENT_BINARY_DIR}/project)
file(REMOVE_RECURSE ${prefix} ${build})
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV} failed:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
foreach(component program development)
  run(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${prefix}
    --component ${component})
endforeach()
run(${prefix}/bin/voussoir --version)
run(${prefix}/bin/voussoir ${prefix}/share/voussoir/prm/shear_wall.prm
  --set "Output directory=shear_wall")
run(${prefix}/bin/voussoir --check shear_wall)
if(NOT output MATCHES "^shear_wall: carried: balance")
  message(FATAL_ERROR "not proven:\n${output}")
endif()
foreach(file share/voussoir/prm/shear_wall.prm share/man/man1/voussoir.1.gz
    share/bash-completion/completions/voussoir include/voussoir/version.h)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${build} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_BUILD_TYPE=${BUILD_TYPE})
run(${CMAKE_COMMAND} --build ${build})
run(${build}/mean_of_two)
if(NOT output MATCHES "analytic centre: solved")
  message(FATAL_ERROR "not solved:\n${output}")
endif()
# They take as much disk as all the rest.
file(REMOVE_RECURSE ${prefix} ${build})
