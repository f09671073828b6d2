#include "reports/reproduce/dart_text.h"

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"

namespace touchstone {

std::string DartShape(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    return fmt::format("std::make_shared<dart::dynamics::SphereShape>({})",
                       Literal(sphere->radius));
  }
  return fmt::format("std::make_shared<dart::dynamics::BoxShape>(Eigen::Vector3d({}))",
                     Literals(Eigen::Vector3d(2 * std::get<Box>(shape).half_extents)));
}

std::string FindDart() {
  return "find_package(DART REQUIRED CONFIG)\n"
         "add_library(engine INTERFACE)\n"
         "target_link_libraries(engine INTERFACE dart)\n";
}

}  // namespace touchstone
