# Writes a fault as a program in WORK, builds and runs it, and sets `output` to what it prints.
# Fails if it does not compile or does not show the fault; if CORRECTION is given, a file of
# statements that correct `answer`, unless the fault is gone. Included by the tests, which
# document the variables.
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${PROGRAM} reproduce ${SCENARIO} --for ${ORACLE} --measure ${MEASURE} --out ${WORK})
set(expected_code 1)
if(DEFINED CORRECTION)
  set(expected_code 0)
  file(READ ${WORK}/reproduce.cc text)
  file(READ ${CORRECTION} correction)
  set(asked "  const Answer answer = Ask();\n")
  string(FIND "${text}" "${asked}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "the program does not ask as expected")
  endif()
  string(REPLACE "${asked}" "  Answer answer = Ask();\n${correction}" text "${text}")
  file(WRITE ${WORK}/reproduce.cc "${text}")
endif()
run(${CMAKE_COMMAND} -S ${WORK} -B ${WORK}/build -G Ninja
  -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_CXX_FLAGS=-O0)
run(${CMAKE_COMMAND} --build ${WORK}/build)
execute_process(COMMAND ${WORK}/build/reproduce OUTPUT_VARIABLE output RESULT_VARIABLE code)
message("${output}")
if(NOT code EQUAL expected_code)
  message(FATAL_ERROR "exit code ${code}; expected ${expected_code}: the fault is there if 1")
endif()
