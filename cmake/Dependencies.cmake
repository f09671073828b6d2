# Finds every third-party library and provides each as one imported target. No other file
# calls find_package, so a version is changed, or an engine dropped, in one place.
# The installed package includes this file too: its users need the libraries that it was
# built with.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(CLI11 2 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Boost 1.74 REQUIRED)  # Multiprecision and Math, headers only
find_package(tomlplusplus 3.3 REQUIRED)
find_package(ZLIB 1.2 REQUIRED)
find_package(SQLite3 3.24 REQUIRED)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET GLOBAL libhwy>=1.0)  # SIMD chosen at run time
pkg_check_modules(mpfr REQUIRED IMPORTED_TARGET GLOBAL mpfr>=4)

# Engines are optional: without one, its oracle states the package to install.
pkg_check_modules(ode QUIET IMPORTED_TARGET GLOBAL ode>=0.16)
pkg_check_modules(bullet_double QUIET IMPORTED_TARGET GLOBAL bullet-float64>=3.24)
pkg_check_modules(bullet_float QUIET IMPORTED_TARGET GLOBAL bullet>=3.24)
pkg_check_modules(ccd QUIET IMPORTED_TARGET GLOBAL ccd>=2.0)
find_package(fcl 0.7 QUIET)
find_package(DART 6.12 QUIET CONFIG)
remove_definitions(-DBOOST_TEST_DYN_LINK)  # DART defines it for the whole folder.
# Debian's CMake configuration of MuJoCo refers to a folder that no package contains.
find_library(TOUCHSTONE_MUJOCO_LIBRARY mujoco)
find_path(TOUCHSTONE_MUJOCO_INCLUDE mujoco/mujoco.h)
mark_as_advanced(TOUCHSTONE_MUJOCO_LIBRARY TOUCHSTONE_MUJOCO_INCLUDE)
if(TOUCHSTONE_MUJOCO_LIBRARY AND TOUCHSTONE_MUJOCO_INCLUDE AND NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco INTERFACE IMPORTED GLOBAL)
  target_link_libraries(mujoco::mujoco INTERFACE ${TOUCHSTONE_MUJOCO_LIBRARY})
  target_include_directories(mujoco::mujoco INTERFACE ${TOUCHSTONE_MUJOCO_INCLUDE})
endif()
foreach(engine ode bullet_double bullet_float ccd dart fcl mujoco)
  string(TOUPPER ${engine} upper)
  option(TOUCHSTONE_WITH_${upper} "Build the ${engine} oracle where the library is present" ON)
  if(TOUCHSTONE_WITH_${upper} AND (TARGET PkgConfig::${engine} OR TARGET ${engine}
      OR TARGET ${engine}::${engine}))
    set(TOUCHSTONE_HAS_${upper} ON)
  else()
    set(TOUCHSTONE_HAS_${upper} OFF)
  endif()
endforeach()

if(TOUCHSTONE_TESTS)
  find_package(GTest 1.12 REQUIRED)
  find_package(rapidcheck REQUIRED)
  set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE ON)
  find_package(CGAL 5.5 REQUIRED)
  include(GoogleTest)
endif()
