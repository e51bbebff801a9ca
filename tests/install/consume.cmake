function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
execute_process(COMMAND ${WORK}/build/runs ${SCENE} ${WORK}/trace.ndjson COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/judges ${WORK}/trace.ndjson COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/asks COMMAND_ERROR_IS_FATAL ANY)
