# Compiles with ccache if it is installed, so that a second build of the same sources takes
# seconds. For precompiled headers, ccache must ignore that it cannot see their macros and dates
# in the source file (CCACHE_SLOPPINESS). It must not read their 140 MB again for every
# file (CCACHE_INODECACHE).
find_program(TOUCHSTONE_CCACHE ccache)
mark_as_advanced(TOUCHSTONE_CCACHE)
if(TOUCHSTONE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_INODECACHE=true ${TOUCHSTONE_CCACHE})
endif()
