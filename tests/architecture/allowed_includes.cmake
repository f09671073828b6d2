# Checks the architecture. Fails if a file includes a header that its folder must not
# include, or if headers include each other in a cycle.
#   cmake -D ROOT=<source dir> -P allowed_includes.cmake
#
# A rule is "folder => headers it may include"; both sides are regular expressions. The
# first rule whose folder matches a file decides, so the narrower rules come first.

cmake_minimum_required(VERSION 3.24)

set(own_rules
  # The corrected engine never calls the specimens.
  "engine/printed/ => engine/"
  "engine/simd/ => engine/simd/"
  "engine/threads/ => engine/threads/"
  "engine/collision/ => engine/(simd|collision)/"
  "engine/dynamics/body/ => engine/(collision|dynamics/body)/"
  "engine/dynamics/broad_phase/ => engine/(simd|threads|dynamics/(body|broad_phase))/"
  "engine/dynamics/joints/ => engine/dynamics/(body|joints)/"
  "engine/dynamics/contacts/ => engine/(simd|threads|collision|dynamics/(body|broad_phase|contacts))/"
  "engine/dynamics/solver/ => engine/(simd|threads|dynamics/(body|contacts|solver))/"
  "engine/dynamics/impacts/ => engine/(threads|collision|dynamics/(body|contacts|solver|impacts))/"
  "engine/dynamics/world/ => engine/(simd|threads|dynamics)/"
  "engine/ => engine/(simd|threads|collision|dynamics)/|engine/(dynamics/)?[a-z_]+[.]h"
  "scenarios/ => scenarios/"
  # Only the cookbook adapter sees the engine, so that no oracle is right because it ran
  # the code it judges.
  "oracles/cookbook/ => (oracles|scenarios|engine)/"
  "oracles/ => (oracles|scenarios)/"
  # The referee sees questions, never an answer.
  "reports/referee/ => (reports/referee|scenarios)/"
  # Only the benchmark runs engines in child processes of its own.
  "reports/bench/ => (reports|scenarios)/|oracles/(oracle|contact_answer|simulation|trajectory)[.]h|oracles/isolation/"
  "reports/ => (reports|scenarios)/|oracles/(oracle|contact_answer|simulation|trajectory)[.]h"
  "cli/ => (cli|reports|oracles|scenarios)/")

# The headers of a third-party library may be included only by the files that wrap it.
set(library_rules
  "ode/ => oracles/ode/.*[.]cc"
  "fcl/ => oracles/fcl/.*[.]cc"
  "ccd/ => oracles/libccd/.*[.]cc"
  "dart/ => oracles/dart/"
  "mujoco/ => oracles/mujoco/"
  "(bt[A-Z]|Bullet|LinearMath/) => oracles/bullet/"
  "hwy/ => engine/"
  "toml[+][+]/ => scenarios/toml/parser[.]h|reports/.*[.]cc"
  "(boost/multiprecision|mpfr) => reports/referee/"
  "boost/math => reports/worlds/.*[.]cc"
  "nlohmann/ => (reports|scenarios|cli)/.*[.]cc"
  "CLI/ => cli/.*[.]cc"
  "CGAL/ => tests/")

# Sets `left` and `right` to the two sides of `rule`.
macro(split_rule rule)
  string(REGEX REPLACE " => .*" "" left "${rule}")
  string(REGEX REPLACE ".* => " "" right "${rule}")
endmacro()

set(broken)
set(headers)
set(seen 0)
foreach(room engine scenarios oracles reports cli)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${room}/*.h ${ROOT}/${room}/*.cc)
  foreach(file IN LISTS files)
    math(EXPR seen "${seen} + 1")
    set(own)
    file(STRINGS ${ROOT}/${file} includes REGEX "^#include")
    foreach(line IN LISTS includes)
      if(line MATCHES "\"(.*)\"")
        set(header ${CMAKE_MATCH_1})
        list(APPEND own ${header})
        foreach(rule IN LISTS own_rules)
          split_rule("${rule}")
          if(file MATCHES "^${left}")
            if(NOT header MATCHES "^(${right})")
              list(APPEND broken "${file}: ${line}")
            endif()
            break()
          endif()
        endforeach()
      elseif(line MATCHES "<(.*)>")
        set(header ${CMAKE_MATCH_1})
        foreach(rule IN LISTS library_rules)
          split_rule("${rule}")
          if(header MATCHES "^${left}" AND NOT file MATCHES "^${right}")
            list(APPEND broken "${file}: ${line}")
          endif()
        endforeach()
      endif()
    endforeach()
    if(file MATCHES "[.]h$")
      list(APPEND headers ${file})
      set(includes_of_${file} ${own})
    endif()
  endforeach()
endforeach()

if(seen LESS 15)
  message(FATAL_ERROR "Only ${seen} files were read: is ROOT the source folder?")
endif()
if(broken)
  list(JOIN broken "\n  " broken)
  message(FATAL_ERROR "Includes that break the architecture:\n  ${broken}")
endif()

# A header is settled once all its includes are. The headers that never settle form a
# cycle or depend on one.
set(open ${headers})
while(TRUE)
  set(still_open)
  foreach(header IN LISTS open)
    set(waits FALSE)
    foreach(included IN LISTS includes_of_${header})
      if(included IN_LIST open)
        set(waits TRUE)
      endif()
    endforeach()
    if(waits)
      list(APPEND still_open ${header})
    endif()
  endforeach()
  if(NOT still_open)
    break()
  elseif(still_open STREQUAL open)
    list(JOIN open "\n  " open)
    message(FATAL_ERROR "Headers that include each other in a cycle, or depend on one:\n  ${open}")
  endif()
  set(open ${still_open})
endwhile()
list(LENGTH headers count)
message(STATUS "${seen} files, ${count} headers: every include obeys the rules")
