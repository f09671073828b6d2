#include "reports/reproduce/ode_text.h"

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"

namespace touchstone {
namespace {

struct Construct {
  std::string operator()(const Sphere& s) const {
    return fmt::format("dCreateSphere(nullptr, {})", Literal(s.radius));
  }
  std::string operator()(const Box& s) const {
    return fmt::format("dCreateBox(nullptr, {})",
                       Literals(Eigen::Vector3d(2 * s.half_extents)));
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format("dCreateCapsule(nullptr, {}, {})", Literal(s.radius),
                       Literal(2 * s.half_length));
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format("dCreateCylinder(nullptr, {}, {})", Literal(s.radius),
                       Literal(2 * s.half_length));
  }
  std::string operator()(const Cone&) const { throw CannotReproduce("ODE has no cone"); }
  std::string operator()(const ConvexHull&) const {
    throw CannotReproduce("programs for convex hulls in ODE are not supported");
  }
  std::string operator()(const HalfSpace&) const { return ""; }
};

}  // namespace

std::string OdeShape(const Shape& shape) {
  return std::visit(Construct{}, shape);
}

std::string FindOde() {
  return "find_package(PkgConfig REQUIRED)\n"
         "pkg_check_modules(ode REQUIRED IMPORTED_TARGET ode)\n"
         "add_library(engine INTERFACE)\n"
         "target_link_libraries(engine INTERFACE PkgConfig::ode)\n";
}

}  // namespace touchstone
