# Compares the error that a program prints in `output` with the values of the findings of that
# measure in the report of WORK/run, to 12 digits, or to SLACK if given: a number of the unit of
# the measure. Included by the tests, which document the variables.
if(NOT output MATCHES "\n${MEASURE}: error ([^,]+), allowed ([^\n]+)\n")
  message(FATAL_ERROR "no error of ${MEASURE} is printed")
endif()
set(printed ${CMAKE_MATCH_1})
if(NOT DEFINED SLACK)
  set(SLACK 0)
endif()

file(STRINGS ${WORK}/run/report.jsonl lines REGEX "^{\"kind\":\"finding\"")
set(values)
foreach(line IN LISTS lines)
  # A list splits lines at semicolons, which only texts have; they follow the value.
  if(line MATCHES "\"oracle\":\"${ORACLE}\".*\"measure\":\"${MEASURE}\".*\"value\":([^,]+),")
    list(APPEND values ${CMAKE_MATCH_1})
  endif()
endforeach()
set(is_found FALSE)
foreach(value IN LISTS values)
  execute_process(COMMAND awk -v a=${printed} -v b=${value} -v s=${SLACK}
    "BEGIN { d = a - b; exit !(d * d <= 1e-24 * b * b || d * d <= s * s) }" RESULT_VARIABLE code)
  if(code EQUAL 0)
    set(is_found TRUE)
  endif()
endforeach()
if(NOT is_found)
  message(FATAL_ERROR "the program's error is ${printed}; expected that of the adapter: ${values}")
endif()
