# The CMake package: find_package(touchstone) gives the targets touchstone::*.
