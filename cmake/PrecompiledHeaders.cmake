# Precompiled headers. Most translation units parse the same headers, so these are parsed once
# for the libraries and once for the tests. No file may rely on them: each header is still
# compiled alone (all_verify_interface_header_sets), and TOUCHSTONE_PCH=OFF disables them.
set(library_headers
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant>
  <vector>
  <Eigen/Geometry> <Eigen/LU> <fmt/format.h> <fmt/ranges.h>)
set(test_headers ${library_headers} <gmock/gmock.h> <gtest/gtest.h>)

target_compile_options(touchstone_flags INTERFACE
  # ccache must see which headers were precompiled, but not the time.
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
  $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)

# touchstone_precompile(<owner> <option>... HEADERS <header>... [USES <target>...])
function(touchstone_precompile owner)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;USES")
  file(CONFIGURE OUTPUT ${owner}.cc CONTENT "")  # a target needs a source
  add_library(${owner} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${owner}.cc)
  target_compile_options(${owner} PRIVATE ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${owner} PRIVATE touchstone_flags Eigen3::Eigen fmt::fmt ${ARG_USES})
  target_precompile_headers(${owner} PRIVATE ${ARG_HEADERS})
endfunction()

# touchstone_use_precompiled(<target>)
#
# Only targets with the same options may share precompiled headers: otherwise g++ would
# silently use the optimisation options of the headers for the file. A library with its own
# options precompiles its own headers.
function(touchstone_use_precompiled target)
  get_target_property(type ${target} TYPE)
  get_target_property(options ${target} COMPILE_OPTIONS)
  get_target_property(uses ${target} LINK_LIBRARIES)
  get_target_property(exempt ${target} DISABLE_PRECOMPILE_HEADERS)
  if(exempt)
    return()
  elseif(type STREQUAL "MODULE_LIBRARY" OR (type STREQUAL "STATIC_LIBRARY" AND options))
    target_precompile_headers(${target} PRIVATE ${library_headers})
  elseif(type STREQUAL "STATIC_LIBRARY")
    target_precompile_headers(${target} REUSE_FROM touchstone_library_headers)
  elseif(type STREQUAL "EXECUTABLE" AND uses MATCHES "GTest::" AND NOT options)
    target_precompile_headers(${target} REUSE_FROM touchstone_test_headers)
  else()
    return()
  endif()
  # The headers were compiled with these macros, so their users must define them too.
  target_compile_definitions(${target} PRIVATE
    $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
endfunction()

# touchstone_precompiled_headers(<folder>)
#
# Applies touchstone_use_precompiled() to every target in <folder> and below.
function(touchstone_precompiled_headers folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(target ${targets})
    touchstone_use_precompiled(${target})
  endforeach()
  foreach(subfolder ${below})
    touchstone_precompiled_headers(${subfolder})
  endforeach()
endfunction()

touchstone_precompile(touchstone_library_headers HEADERS ${library_headers})
if(TOUCHSTONE_TESTS)
  # Programs are compiled with -fPIE, libraries with -fPIC.
  touchstone_precompile(touchstone_test_headers -fPIE HEADERS ${test_headers}
    USES GTest::gmock GTest::gtest)
  set_target_properties(touchstone_test_headers PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endif()
touchstone_precompiled_headers(${PROJECT_SOURCE_DIR})
