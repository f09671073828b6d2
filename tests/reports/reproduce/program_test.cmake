# Writes a fault as a program, builds and runs it, and compares its answer with that of the
# adapter, digit by digit, and its error with the value of the finding. Detects programs that do not compile, that set up the engine
# otherwise than the adapter does, and that miss the fault.
#   cmake -D PROGRAM=<touchstone> -D ORACLE=<name> -D SCENARIO=<id> -D MEASURE=<name>
#         -D CXX=<compiler> -D WORK=<scratch dir> -P program_test.cmake
cmake_minimum_required(VERSION 3.24)

include(${CMAKE_CURRENT_LIST_DIR}/build_program.cmake)

# The ledger may know the fault, so the exit code of the run says nothing.
execute_process(COMMAND ${PROGRAM} run ${SCENARIO} --subject ${ORACLE} --against ${ORACLE}
  --out ${WORK}/run OUTPUT_QUIET RESULT_VARIABLE code)
file(STRINGS ${WORK}/run/report.jsonl line REGEX "^{\"kind\":\"scenario\"")
string(REPLACE "\\;" ";" line "${line}")
string(JSON answer GET "${line}" answers 0)
string(JSON name GET "${answer}" oracle)
if(NOT name STREQUAL ORACLE)
  message(FATAL_ERROR "the first answer is that of ${name}; expected ${ORACLE}")
endif()

# An answer that is missing has nothing to compare.
if(MEASURE STREQUAL "answering")
  if(NOT output MATCHES "no answer: (Aborted|Segmentation fault)")
    message(FATAL_ERROR "the program has an answer; expected none")
  endif()
  return()
endif()

string(JSON touching GET "${answer}" touching)
if(touching)
  set(expected "read as: touching, ")
else()
  set(expected "read as: apart, ")
endif()
string(JSON separation ERROR_VARIABLE missing GET "${answer}" separation)
if(missing OR separation STREQUAL "")
  string(APPEND expected "no separation\n")
else()
  # CMake prints numbers with 17 digits as printf does, except for its .0 after integers.
  string(REGEX REPLACE "[.]0$" "" separation "${separation}")
  string(APPEND expected "separation ${separation}\n")
endif()
string(FIND "${output}" "${expected}" found)
if(found EQUAL -1)
  message(FATAL_ERROR "the adapter's answer is not that of the program; expected ${expected}")
endif()

# A rounding of the scene may be more than 12 digits of a small error. Decisions have no size.
if(MEASURE STREQUAL "touching")
  return()
endif()
set(SLACK 1e-14)
include(${CMAKE_CURRENT_LIST_DIR}/compare_error.cmake)
