# The CMake package. find_package(touchstone) provides the targets touchstone::*, and
# touchstone::touchstone for all of them. The install prefix is relocatable.
include(CMakePackageConfigHelpers)

set(package_dir lib/cmake/touchstone)

add_library(touchstone_touchstone INTERFACE)
target_link_libraries(touchstone_touchstone INTERFACE
  touchstone::cli touchstone::sweep touchstone::writers touchstone::oracles)
set_target_properties(touchstone_touchstone PROPERTIES EXPORT_NAME touchstone)
install(TARGETS touchstone_touchstone EXPORT touchstone)
install(EXPORT touchstone NAMESPACE touchstone:: FILE touchstone-targets.cmake
  DESTINATION ${package_dir})

configure_package_config_file(cmake/touchstone-config.cmake.in
  ${PROJECT_BINARY_DIR}/touchstone-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/touchstone-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/touchstone-config.cmake
  ${PROJECT_BINARY_DIR}/touchstone-config-version.cmake
  cmake/Dependencies.cmake
  DESTINATION ${package_dir})

install(TARGETS touchstone)
install(DIRECTORY scenarios/catalogue DESTINATION share/touchstone)
install(FILES scenarios/known_discrepancies.toml scenarios/known_discrepancies.bounds
  DESTINATION share/touchstone OPTIONAL)
install(FILES docs/report.schema.json DESTINATION share/touchstone)
