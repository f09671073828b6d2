# Fails if a file of the engine or of its tests uses a word that docs/glossary.md has retired.
# The words are those of the line "The test refuses: …" there.
#   cmake -D ROOT=<source dir> -P retired_words.cmake
cmake_minimum_required(VERSION 3.24)

file(READ ${ROOT}/docs/glossary.md glossary)
if(NOT glossary MATCHES "The test refuses: ([a-z, \n]+)[.]")
  message(FATAL_ERROR "docs/glossary.md: no line \"The test refuses: …\"")
endif()
string(REGEX REPLACE "[, \n]+" ";" words "${CMAKE_MATCH_1}")
list(LENGTH words count)
if(count LESS 10)
  message(FATAL_ERROR "docs/glossary.md: ${count} retired words, expected at least 10")
endif()

file(GLOB_RECURSE files RELATIVE ${ROOT}
  ${ROOT}/engine/*.h ${ROOT}/engine/*.cc ${ROOT}/tests/engine/*.h ${ROOT}/tests/engine/*.cc)
list(LENGTH files read)
if(read LESS 15)
  message(FATAL_ERROR "Only ${read} files were read: is ROOT the source folder?")
endif()

set(found)
foreach(file IN LISTS files)
  file(READ ${ROOT}/${file} text)
  # The data structure, and its functions in the standard library.
  string(REGEX REPLACE "[Bb]inary[ _]heap|(push|pop|make)_heap" "" text "${text}")
  foreach(word IN LISTS words)
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} capital)
    # Matches a word, a part of snake_case or a part of CamelCase, and the plural.
    if(text MATCHES "(^|[^A-Za-z])(${word}(e?s)?)([^A-Za-z]|$)"
        OR text MATCHES "(${capital}${rest}(e?s)?)([^a-z]|$)")
      list(APPEND found "${file}: ${word}")
    endif()
  endforeach()
endforeach()
if(found)
  list(JOIN found "\n  " found)
  message(FATAL_ERROR "Retired words (see docs/glossary.md for the field's):\n  ${found}")
endif()
message(STATUS "${read} files: none of ${count} retired words")
