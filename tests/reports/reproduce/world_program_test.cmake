# Writes a fault of a motion as a program, builds and runs it, and compares its error with the
# value of the finding, to 12 digits. Detects programs that do not compile, that set up the
# engine otherwise than the adapter does, and that miss the fault.
#   cmake -D PROGRAM=<touchstone> -D ORACLE=<name> -D SCENARIO=<id or file> -D MEASURE=<name>
#         -D CXX=<compiler> -D WORK=<scratch dir> -P world_program_test.cmake
cmake_minimum_required(VERSION 3.24)

include(${CMAKE_CURRENT_LIST_DIR}/build_program.cmake)

# The finding of the adapter's motion. The ledger may know it, so the exit code says nothing.
execute_process(COMMAND ${PROGRAM} run ${SCENARIO} --subject ${ORACLE} --against ${ORACLE}
  --out ${WORK}/run OUTPUT_QUIET RESULT_VARIABLE code)
include(${CMAKE_CURRENT_LIST_DIR}/compare_error.cmake)
