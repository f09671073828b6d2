# Writes a fault as a program, corrects the engine's answer by the statements of a file, and
# expects the program to find the fault gone: because its check passes, or, with the correction
# "apart", because the answer says that the bodies are apart. Detects checks that hold a right
# answer for wrong.
#   cmake -D PROGRAM=<touchstone> -D ORACLE=<name> -D SCENARIO=<id> -D MEASURE=<name>
#         -D CORRECTION=<file> -D CXX=<compiler> -D WORK=<scratch dir>
#         -P right_answer_test.cmake
cmake_minimum_required(VERSION 3.24)

include(${CMAKE_CURRENT_LIST_DIR}/build_program.cmake)
if(NOT output MATCHES "\nThe fault is gone.\n")
  message(FATAL_ERROR "the program does not say that the fault is gone")
endif()
get_filename_component(correction ${CORRECTION} NAME_WE)
if(output MATCHES "That is not counted")
  if(NOT correction STREQUAL "apart")
    message(FATAL_ERROR "the program does not check the corrected answer")
  endif()
elseif(correction STREQUAL "apart")
  message(FATAL_ERROR "the program counts an answer that says apart")
endif()
