# Writes a fault of a motion as a program, builds and runs it, and compares its error with the
# value of the finding, to 12 digits. Detects programs that do not compile, that set up the
# engine otherwise than the adapter does, and that miss the fault.
#   cmake -D PROGRAM=<touchstone> -D ORACLE=<name> -D SCENARIO=<id or file> -D MEASURE=<name>
#         -D CXX=<compiler> -D WORK=<scratch dir> -P world_program_test.cmake
cmake_minimum_required(VERSION 3.24)

include(${CMAKE_CURRENT_LIST_DIR}/build_program.cmake)

if(NOT output MATCHES "\n${MEASURE}: error ([^,]+), allowed ([^\n]+)\n")
  message(FATAL_ERROR "no error of ${MEASURE} is printed")
endif()
set(printed ${CMAKE_MATCH_1})

# The finding of the adapter's motion. The ledger may know it, so the exit code says nothing.
execute_process(COMMAND ${PROGRAM} run ${SCENARIO} --subject ${ORACLE} --against ${ORACLE}
  --out ${WORK}/run OUTPUT_QUIET RESULT_VARIABLE code)
file(STRINGS ${WORK}/run/report.jsonl lines REGEX "^{\"kind\":\"finding\"")
set(values)
foreach(line IN LISTS lines)
  # A list splits lines at semicolons, which only texts have; they follow the value.
  if(line MATCHES "\"oracle\":\"${ORACLE}\".*\"measure\":\"${MEASURE}\".*\"value\":([^,]+),")
    list(APPEND values ${CMAKE_MATCH_1})
  endif()
endforeach()
foreach(value IN LISTS values)
  execute_process(COMMAND awk -v a=${printed} -v b=${value}
    "BEGIN { d = a - b; exit !(d * d <= 1e-24 * b * b) }" RESULT_VARIABLE code)
  if(code EQUAL 0)
    return()
  endif()
endforeach()
message(FATAL_ERROR "the program's error is ${printed}; expected that of the adapter: ${values}")
