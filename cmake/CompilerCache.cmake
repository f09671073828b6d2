# Compiles through ccache where it is installed; a second build of the same
# sources is then a matter of seconds.
find_program(TOUCHSTONE_CCACHE ccache)
mark_as_advanced(TOUCHSTONE_CCACHE)
if(TOUCHSTONE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${TOUCHSTONE_CCACHE})
endif()
