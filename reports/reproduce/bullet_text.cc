#include "reports/reproduce/bullet_text.h"

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"

namespace touchstone {
namespace {

/** Writes the definition of a shape. */
struct Define {
  std::string_view name;

  // Bullet stores half extents minus the margin. Changing the margin loses digits, so the
  // half extents are set once more, as in the adapter.
  std::string WithoutMargin(const char* type, const Eigen::Vector3d& half) const {
    return fmt::format(
        "  {1} {0}({2});\n  {0}.setMargin(0);\n"
        "  {0}.setImplicitShapeDimensions({2});\n",
        name, type, BulletVector(half));
  }
  std::string operator()(const Sphere& s) const {
    return fmt::format("  btSphereShape {}({});\n", name, BulletScalar(s.radius));
  }
  std::string operator()(const Box& s) const {
    return WithoutMargin("btBoxShape", s.half_extents);
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format("  btCapsuleShapeZ {}({}, {});\n", name, BulletScalar(s.radius),
                       BulletScalar(2 * s.half_length));
  }
  std::string operator()(const Cylinder& s) const {
    return WithoutMargin("btCylinderShapeZ", {s.radius, s.radius, s.half_length});
  }
  std::string operator()(const Cone& s) const {
    return fmt::format("  btConeShapeZ {0}({1}, {2});\n  {0}.setMargin(0);\n", name,
                       BulletScalar(s.radius), BulletScalar(2 * s.half_height));
  }
  std::string operator()(const ConvexHull& s) const {
    std::string text = fmt::format("  btConvexHullShape {};\n", name);
    for (const Eigen::Vector3d& vertex : s.vertices)
      text += fmt::format("  {}.addPoint({}, false);\n", name, BulletVector(vertex));
    return text + fmt::format("  {0}.setMargin(0);\n  {0}.recalcLocalAabb();\n", name);
  }
  std::string operator()(const HalfSpace&) const {
    return fmt::format(
        "  btStaticPlaneShape {0}(btVector3(0, 0, 1), 0);\n  {0}.setMargin(0);\n", name);
  }
};

}  // namespace

std::string BulletScalar(double x) {
  return fmt::format("btScalar({})", Literal(x));
}

std::string BulletVector(const Eigen::Vector3d& v) {
  return fmt::format("btVector3({}, {}, {})", BulletScalar(v.x()), BulletScalar(v.y()),
                     BulletScalar(v.z()));
}

std::string DefineBulletShape(std::string_view name, const Shape& shape) {
  return std::visit(Define{name}, shape);
}

std::string_view BulletBuild(std::string_view oracle) {
  return oracle.starts_with("bullet_float") ? "bullet" : "bullet-float64";
}

std::string FindBullet(std::string_view oracle) {
  return fmt::format(
      "find_package(PkgConfig REQUIRED)\n"
      "pkg_check_modules(bullet REQUIRED IMPORTED_TARGET {})\n"
      "add_library(engine INTERFACE)\n"
      "target_link_libraries(engine INTERFACE PkgConfig::bullet)\n",
      BulletBuild(oracle));
}

}  // namespace touchstone
