# Modules for engines whose libraries cannot be linked into one program. They are loaded at
# run time, along the run path of the program (docs/decisions/0005).
set(TOUCHSTONE_MODULE_DIR lib/touchstone)  # below the build tree, and below the prefix
list(APPEND CMAKE_BUILD_RPATH ${PROJECT_BINARY_DIR}/${TOUCHSTONE_MODULE_DIR})
list(APPEND CMAKE_INSTALL_RPATH $ORIGIN/../${TOUCHSTONE_MODULE_DIR})

# touchstone_engine_module(<target> SOURCES <cc>... USES <target>...)
function(touchstone_engine_module target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;USES")
  add_library(${target} MODULE ${ARG_SOURCES})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE touchstone_flags ${ARG_USES})
  set_target_properties(${target} PROPERTIES
    PREFIX ""
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${TOUCHSTONE_MODULE_DIR}
    # A symbol that two modules define must stay separate in each.
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(TOUCHSTONE_INSTALL)
    install(TARGETS ${target} LIBRARY DESTINATION ${TOUCHSTONE_MODULE_DIR})
  endif()
endfunction()

# touchstone_opens_modules(<target> <module>...)
#
# The static library <target> loads <module>... at run time. Programs that link it get the run
# path.
function(touchstone_opens_modules target)
  if(ARGN)  # none where its engine is not installed
    add_dependencies(${target} ${ARGN})
  endif()
  target_link_options(${target} INTERFACE
    $<INSTALL_INTERFACE:-Wl,-rpath,$<INSTALL_PREFIX>/${TOUCHSTONE_MODULE_DIR}>)
  if(NOT PROJECT_IS_TOP_LEVEL)  # CMAKE_BUILD_RPATH does not reach the parent's programs
    target_link_options(${target} INTERFACE
      $<BUILD_INTERFACE:-Wl,-rpath,${PROJECT_BINARY_DIR}/${TOUCHSTONE_MODULE_DIR}>)
  endif()
endfunction()
