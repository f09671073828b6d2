# Checks the architecture. Fails if a file includes a header that its layer must not
# include, if a file has no layer, if a layer has no files, or if headers include each other
# in a cycle.
#   cmake -D ROOT=<source dir> -P allowed_includes.cmake
#
# A rule is "layer => headers of other layers that it may include"; both sides are regular
# expressions. The last rule that matches a file decides its layer, so exceptions follow
# their layer. The rules are in order from the bottom up: no file may include a header of a
# later rule, whatever its right side says. Layers thus never depend on each other in a
# circle.

cmake_minimum_required(VERSION 3.24)

set(own_rules
  # The cookbook engine.
  "engine/simd/ => nothing"
  "engine/threads/ => nothing"
  "engine/collision/ => engine/simd/"
  "engine/dynamics/body/ => engine/collision/"
  "engine/dynamics/broad_phase/ => engine/(simd|threads|dynamics/body)/"
  "engine/dynamics/joints/ => engine/dynamics/body/"
  "engine/dynamics/contacts/ => engine/(simd|threads|collision|dynamics/(body|broad_phase))/"
  "engine/dynamics/solver/ => engine/(simd|threads|dynamics/(body|contacts))/"
  "engine/dynamics/impacts/ => engine/(threads|collision|dynamics/(body|contacts|solver))/"
  "engine/dynamics/world/ => engine/(simd|threads|dynamics)/"
  # The published recipes share only vocabulary with the corrected engine.
  "engine/printed/ => engine/collision/(rounding|shape)[.]h"

  "scenarios/ => nothing"

  # The interface of the oracles, and the child processes.
  "oracles/[a-z_]+[.] => scenarios/([a-z_]+|worlds/[a-z_]+)[.]h"
  "oracles/isolation/ => oracles/[a-z_]+[.]h"
  "oracles/protocol/ => oracles/(isolation/(last_line|living_child|sanitized_fork|unique_fd)|[a-z_]+)[.]h|scenarios/([a-z_]+|worlds/[a-z_]+)[.]h")

# No adapter includes another.
foreach(adapter bullet cookbook dart fcl libccd mujoco ode)
  set(rule "oracles/${adapter}/ => oracles/(isolation/isolated_oracle|[a-z_]+)[.]h")
  string(APPEND rule "|scenarios/([a-z_]+|worlds/[a-z_]+)[.]h")
  # Only the cookbook adapter sees the engine, so that no oracle is right because it ran
  # the code it judges.
  if(adapter STREQUAL "cookbook")
    string(APPEND rule "|engine/(collision|dynamics/world|printed)/")
  endif()
  list(APPEND own_rules "${rule}")
endforeach()

list(APPEND own_rules
  "oracles/oracle_registry[.] => oracles/([a-z_]+|[a-z]+/[a-z_]+_oracles?)[.]h"

  # The vocabulary of the reports.
  "reports/text/ => nothing"
  "reports/threads/ => oracles/standard_arithmetic[.]h"
  "reports/finding/ => reports/text/|scenarios/measure_kind[.]h"
  # The referee sees questions, never an answer.
  "reports/referee/ => scenarios/[a-z_]+[.]h"
  "reports/measures/ => reports/referee/|oracles/contact_answer[.]h|scenarios/[a-z_]+[.]h"
  "reports/contacts/ => reports/(text|finding|referee|measures)/|oracles/(contact_answer|oracle|stated_tolerance)[.]h|scenarios/[a-z_]+[.]h"
  # Closed forms know nothing of engines' names, laws or findings.
  "reports/worlds/truth/ => oracles/trajectory[.]h|scenarios/worlds/"
  "reports/worlds/law_support/ => reports/(text|finding|referee|worlds/truth)/|oracles/(oracle|trajectory)[.]h|scenarios/([a-z_]+|worlds/[a-z_]+)[.]h"
  "reports/worlds/laws/ => reports/(text|worlds/(truth|law_support))/"
  # The study finds a law by its name and includes no single law.
  "reports/worlds/study/ => reports/((text|threads|finding|worlds/(truth|law_support))/|worlds/laws/laws[.]h)|oracles/(isolation/motion_store|oracle|stopwatch|trajectory)[.]h|scenarios/(diagnostic[.]h|schema/(nearest_name|scenario_schema)[.]h|(generators|worlds)/)"
  # Only the benchmark runs engines in child processes of its own.
  "reports/bench/ => reports/(text|referee|measures)/|oracles/(isolation/[a-z_]+|oracle|simulation|trajectory)[.]h|scenarios/([a-z_]+[.]h|(generators|worlds)/)"
  "reports/run_report[.] => reports/(finding/|contacts/contact_result[.]h|worlds/study/world_(result|seconds)[.]h)|oracles/oracle[.]h"
  "reports/ledger/ => reports/((text|finding|referee|measures|contacts)/|run_report[.]h)|scenarios/(diagnostic|validate_scenario|schema/nearest_name)[.]h"
  "reports/accuracy/ => reports/(ledger/|run_report[.]h)"
  "reports/clusters/ => reports/((text|finding|contacts)/|worlds/study/motion_scale[.]h|run_report[.]h|referee/contact_truth[.]h)|scenarios/(contact_query|measure_kind|worlds/world)[.]h"
  "reports/baseline/ => reports/((finding|ledger|contacts|worlds/study)/|run_report[.]h)|scenarios/diagnostic[.]h"
  "reports/run[.] => reports/((threads|finding|referee|measures|contacts|worlds/study|ledger)/|run_report[.]h)|oracles/(oracle|stopwatch)[.]h|scenarios/(scenario|worlds/world_scenario)[.]h"
  "reports/writers/ => scenarios/diagnostic[.]h|reports/((baseline|text|finding|referee|contacts|clusters|worlds/study)/|run_report[.]h)|oracles/(contact_answer|stated_tolerance|trajectory)[.]h|scenarios/(contact_query|scenario_file|worlds/world_scenario)[.]h"
  "reports/sweep/ => reports/((text|threads|finding|referee|contacts|writers|worlds/study)/|run(_report)?[.]h)|oracles/(oracle|stated_tolerance|world_setup)[.]h|scenarios/(generators/|(contact_table|diagnostic|scenario|scenario_file|shape|validate|worlds/world_scenario)[.]h)"
  "reports/journal/ => reports/(finding/|sweep/database[.]h|worlds/study/examine_world[.]h)|oracles/(isolation/(answer_wire|wire)|oracle|stated_tolerance|world_setup)[.]h|scenarios/scenario_file[.]h"
  "reports/shrink/ => reports/((text|finding|writers)/|contacts/body_size[.]h|run(_report)?[.]h|worlds/study/check_claims[.]h)|oracles/oracle[.]h|scenarios/([a-z_]+|worlds/[a-z_]+)[.]h"
  "reports/reproduce/ => reports/(clusters/measure_words[.]h|(text|finding|referee|measures|writers|worlds/truth)/|contacts/(checks/(contact_off_patch|missed_point|patch_coverage|witness_error)|contact_result|normal_claim|tolerances)[.]h|worlds/(study/world_result|law_support/(overlap|subjects)|laws/laws)[.]h)|oracles/(oracle|trajectory|world_setup)[.]h|scenarios/([a-z_]+|worlds/[a-z_]+)[.]h"
  "reports/adapter_check/ => reports/((finding|referee)/|contacts/judge_answer[.]h)|oracles/(isolation/answer_wire|contact_answer|oracle|trajectory)[.]h|scenarios/(generators/generate[.]h|[a-z_]+[.]h|worlds/world[.]h)"
  "reports/triage/ => reports/((text|finding|clusters|shrink|sweep|reproduce|writers)/|contacts/judge_variant[.]h|ledger/glob[.]h|run(_report)?[.]h)|oracles/oracle[.]h|scenarios/(scenario_file|scenario|shape)[.]h"
  "reports/gtest/ => reports/((shrink|sweep|text|writers)/|run(_report)?[.]h|worlds/study/check_claims[.]h)|oracles/(oracle|stated_tolerance)[.]h|scenarios/(scenario_file|worlds/world_scenario)[.]h"

  "cli/[a-z_]+[.] => reports/((text|ledger)/|run[.]h|sweep/question_id[.]h|worlds/study/check_claims[.]h)|oracles/(isolation/living_child|oracle|oracle_registry|protocol/(command|external_oracle|oracles_file))[.]h|scenarios/"
  # The only files that call a cluster; they know nothing of sweeps.
  "cli/slurm/ => cli/(input_error|shell)[.]h|reports/text/shell_quoted[.]h"
  "cli/commands/ => cli/|oracles/protocol/(command|external_oracle|serve)[.]h|reports/(accuracy|adapter_check|baseline|bench|finding|journal|ledger|referee|reproduce|shrink|sweep|text|threads|triage|writers)/|scenarios/"
  # The command line is the only file that knows the commands.
  "cli/command_line[.]cc => cli/|reports/(bench/scene|finding/grade|worlds/study/check_claims)[.]h|scenarios/schema/")

# The headers of a third-party library may be included only by the files that wrap it.
set(library_rules
  "ode/ => oracles/ode/.*[.]cc"
  "fcl/ => oracles/fcl/.*[.]cc"
  "ccd/ => oracles/libccd/.*[.]cc"
  "dart/ => oracles/dart/"
  "mujoco/ => oracles/mujoco/"
  "(bt[A-Z]|Bullet|LinearMath/) => oracles/bullet/"
  "hwy/ => engine/"
  "toml[+][+]/ => scenarios/toml/parser[.]h|oracles/protocol/oracles_file[.]cc|reports/.*[.]cc"
  "(boost/multiprecision|mpfr) => reports/referee/"
  "boost/math => reports/worlds/.*[.]cc"
  "sqlite3[.]h => reports/sweep/database[.]cc"
  "zlib[.]h => reports/writers/data/deflate[.]cc"
  "nlohmann/ => ((reports|scenarios|cli|oracles/protocol)/.*[.]cc|reports/writers/data/json_values[.]h|oracles/protocol/json[.]h)"
  "CLI/ => cli/.*[.]cc"
  "CGAL/ => tests/")

# Sets `left` and `right` to the two sides of `rule`.
macro(split_rule rule)
  string(REGEX REPLACE " => .*" "" left "${rule}")
  string(REGEX REPLACE ".* => " "" right "${rule}")
endmacro()

# Finds the layer of each file, as the index of its rule.
set(without_layer)
set(occupied)
set(own_files)
foreach(top_folder engine scenarios oracles reports cli)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${top_folder}/*.h ${ROOT}/${top_folder}/*.cc)
  foreach(file IN LISTS files)
    set(index 0)
    foreach(rule IN LISTS own_rules)
      split_rule("${rule}")
      if(file MATCHES "^${left}")
        set(layer_of_${file} ${index})
      endif()
      math(EXPR index "${index} + 1")
    endforeach()
    if(DEFINED layer_of_${file})
      list(APPEND occupied ${layer_of_${file}})
      list(APPEND own_files ${file})
    else()
      list(APPEND without_layer ${file})
    endif()
  endforeach()
endforeach()

set(empty)
set(index 0)
foreach(rule IN LISTS own_rules)
  if(NOT index IN_LIST occupied)
    split_rule("${rule}")
    list(APPEND empty ${left})
  endif()
  math(EXPR index "${index} + 1")
endforeach()

set(broken)
set(headers)
foreach(file IN LISTS own_files)
  set(layer ${layer_of_${file}})
  list(GET own_rules ${layer} own_rule)
  set(own)
  file(STRINGS ${ROOT}/${file} includes REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS includes)
    if(line MATCHES "\"(.*)\"")
      set(header ${CMAKE_MATCH_1})
      list(APPEND own ${header})
      split_rule("${own_rule}")
      if(NOT DEFINED layer_of_${header})
        list(APPEND broken "${file}: ${line}: no such header in a layer")
      elseif(layer_of_${header} GREATER layer)
        list(APPEND broken "${file}: ${line}: points up")
      elseif(NOT layer_of_${header} EQUAL layer AND NOT header MATCHES "^(${right})")
        list(APPEND broken "${file}: ${line}: not in the list of its layer")
      endif()
    elseif(line MATCHES "<(.*)>")
      set(header ${CMAKE_MATCH_1})
      foreach(rule IN LISTS library_rules)
        split_rule("${rule}")
        if(header MATCHES "^${left}" AND NOT file MATCHES "^${right}")
          list(APPEND broken "${file}: ${line}: only in ${right}")
        endif()
      endforeach()
    endif()
  endforeach()
  if(file MATCHES "[.]h$")
    list(APPEND headers ${file})
    set(includes_of_${file} ${own})
  endif()
endforeach()

# Prints the list named `faults`, if it has any elements.
macro(report faults title)
  if(${faults})
    list(JOIN ${faults} "\n  " lines)
    message(SEND_ERROR "${title}:\n  ${lines}")
  endif()
endmacro()
report(empty "Layers without files. Is ROOT the source folder? If so, remove their rules")
report(without_layer "Files without a layer. Add a rule for their folder")
report(broken "Includes that break the architecture")
if(empty OR without_layer OR broken)
  return()
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
list(LENGTH own_rules layers)
list(LENGTH own_files count)
message(STATUS "${count} files in ${layers} layers: every include obeys the rules")
