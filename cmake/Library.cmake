# Eigen aligns fixed-size vectors by the widest instructions it is compiled for: without this
# definition, a user's -mavx2 or -march=native would give the types in our headers another
# layout than they have in our libraries, and the program would crash. 16 is Eigen's default
# without such options. Headers check it (scenarios/eigen_alignment.h).
set(TOUCHSTONE_EIGEN_DEFINITIONS EIGEN_MAX_ALIGN_BYTES=16)

# An interface target with the compiler flags of every target.
add_library(touchstone_flags INTERFACE)
target_compile_features(touchstone_flags INTERFACE cxx_std_20)
target_compile_options(touchstone_flags INTERFACE
  # With fused multiply-add, one source could give different results on two machines.
  -ffp-contract=off
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # g++ 12 warns of impossible overlaps in std::string's assignment (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${TOUCHSTONE_WARNINGS_AS_ERRORS}>:-Werror>)
target_compile_definitions(touchstone_flags INTERFACE ${TOUCHSTONE_EIGEN_DEFINITIONS})
if(TOUCHSTONE_SANITIZE)
  target_compile_options(touchstone_flags INTERFACE
    -fsanitize=${TOUCHSTONE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # The address sanitizer finds an access through null or past an object, too; a misaligned
    # one is found only where the processor refuses it. These checks take 40 % of the compile
    # time of a file full of Eigen expressions.
    -fno-sanitize=null,object-size,alignment)
  target_link_options(touchstone_flags INTERFACE -fsanitize=${TOUCHSTONE_SANITIZE})
endif()

# touchstone_library(<name> HEADERS <h>... [INTERNAL <h>...] SOURCES <cc>...
#                    [USES <target>...] [HIDES <target>...])
#
# HEADERS are installed, INTERNAL ones are not. USES lists the targets that the public headers
# include. HIDES lists those that only the .cc files and internal headers include, so that
# consumers inherit neither include paths nor flags. Every header must compile alone.
function(touchstone_library name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;INTERNAL;SOURCES;USES;HIDES")
  add_library(touchstone_${name} STATIC ${ARG_SOURCES})
  add_library(touchstone::${name} ALIAS touchstone_${name})
  target_sources(touchstone_${name} PUBLIC FILE_SET HEADERS
    BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_HEADERS})
  target_link_libraries(touchstone_${name}
    PUBLIC ${ARG_USES} PRIVATE $<BUILD_INTERFACE:touchstone_flags> ${ARG_HIDES})
  target_compile_features(touchstone_${name} PUBLIC cxx_std_20)
  target_compile_definitions(touchstone_${name} PUBLIC ${TOUCHSTONE_EIGEN_DEFINITIONS})
  set_target_properties(touchstone_${name} PROPERTIES
    VERIFY_INTERFACE_HEADER_SETS ON EXPORT_NAME ${name})
  if(ARG_INTERNAL)
    # Not installed: this target only compiles each internal header alone.
    add_library(touchstone_${name}_internal INTERFACE)
    target_sources(touchstone_${name}_internal INTERFACE FILE_SET HEADERS
      BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_INTERNAL})
    target_link_libraries(touchstone_${name}_internal INTERFACE
      touchstone_${name} touchstone_flags ${ARG_HIDES})
    set_target_properties(touchstone_${name}_internal PROPERTIES
      VERIFY_INTERFACE_HEADER_SETS ON)
  endif()
  if(TOUCHSTONE_INSTALL)
    install(TARGETS touchstone_${name} EXPORT touchstone
      FILE_SET HEADERS DESTINATION include/touchstone)
  endif()
endfunction()
