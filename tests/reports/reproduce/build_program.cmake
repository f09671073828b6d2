# Writes a fault as a program in WORK, builds and runs it, and sets `output` to what it prints.
# Fails if it does not compile or does not show the fault. Included by the tests, which
# document the variables.
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${PROGRAM} reproduce ${SCENARIO} --for ${ORACLE} --measure ${MEASURE} --out ${WORK})
run(${CMAKE_COMMAND} -S ${WORK} -B ${WORK}/build -G Ninja
  -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_CXX_FLAGS=-O0)
run(${CMAKE_COMMAND} --build ${WORK}/build)
execute_process(COMMAND ${WORK}/build/reproduce OUTPUT_VARIABLE output RESULT_VARIABLE code)
message("${output}")
if(NOT code EQUAL 1)
  message(FATAL_ERROR "exit code ${code}; expected 1: the fault is there")
endif()
