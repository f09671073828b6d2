# Fails if the README does not say how many scenarios the catalogue has.
#   cmake -D ROOT=<source dir> -P scenario_count.cmake
cmake_minimum_required(VERSION 3.24)

file(GLOB_RECURSE scenarios ${ROOT}/scenarios/catalogue/*.toml)
list(LENGTH scenarios count)
file(READ ${ROOT}/README.md readme)
if(NOT readme MATCHES "all ([0-9]+) scenarios")
  message(FATAL_ERROR "README.md: no \"all N scenarios\"")
endif()
if(NOT CMAKE_MATCH_1 EQUAL count)
  message(FATAL_ERROR
    "README.md: all ${CMAKE_MATCH_1} scenarios; the catalogue has ${count}")
endif()
