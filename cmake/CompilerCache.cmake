# Compiles through ccache where it is installed; a second build of the same
# sources is then a matter of seconds. With precompiled headers it must not mind that their
# macros, dates among them, are not seen in the file itself, and must not read their 140 MB
# again for every file.
find_program(TOUCHSTONE_CCACHE ccache)
mark_as_advanced(TOUCHSTONE_CCACHE)
if(TOUCHSTONE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_INODECACHE=true ${TOUCHSTONE_CCACHE})
endif()
