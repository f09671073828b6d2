#include "reports/reproduce/ode_text.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "scenarios/convex_facets.h"

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
    throw CannotReproduce(
        "programs for worlds with convex hulls in ODE are not supported");
  }
  std::string operator()(const HalfSpace&) const { return ""; }
};

}  // namespace

std::string OdeShape(const Shape& shape) {
  return std::visit(Construct{}, shape);
}

OdeConvex OdeConvexOf(char name, const ConvexHull& hull) {
  const std::optional<ConvexFacets> boundary = BoundaryOf(hull);
  if (!boundary) throw CannotReproduce("the hull is flat, and ODE needs its faces");
  // MPR starts from the geom's origin, which has to be inside the hull.
  const bool is_origin_inside = std::ranges::all_of(
      boundary->facets, [](const ConvexFacet& facet) { return facet.offset > 0; });
  Eigen::Vector3d origin_B = Eigen::Vector3d::Zero();
  if (!is_origin_inside) origin_B = boundary->centre;
  std::string points;
  for (const Eigen::Vector3d& corner : boundary->corners)
    points += fmt::format("\n      {},", Literals(Eigen::Vector3d(corner - origin_B)));
  std::string planes;
  std::string polygons;
  for (const ConvexFacet& facet : boundary->facets) {
    planes += fmt::format("\n      {}, {},", Literals(facet.n_B),
                          Literal(facet.offset - facet.n_B.dot(origin_B)));
    polygons += fmt::format("\n      {},", facet.corners.size());
    for (const int corner : facet.corners) polygons += fmt::format(" {},", corner);
  }
  return {
      fmt::format("  // Normal and offset of each face; the corners; and of each face "
                  "the number of its\n  // corners and their indices, "
                  "counterclockwise from outside.\n"
                  "  static const dReal planes_{0}[] = {{{1}}};\n"
                  "  static const dReal points_{0}[] = {{{2}}};\n"
                  "  static const unsigned polygons_{0}[] = {{{3}}};\n"
                  "  const dGeomID {0} = dCreateConvex(nullptr, planes_{0}, {4}, "
                  "points_{0}, {5}, polygons_{0});\n",
                  name, planes, points, polygons, boundary->facets.size(),
                  boundary->corners.size()),
      origin_B};
}

std::string FindOde() {
  return "find_package(PkgConfig REQUIRED)\n"
         "pkg_check_modules(ode REQUIRED IMPORTED_TARGET ode)\n"
         "add_library(engine INTERFACE)\n"
         "target_link_libraries(engine INTERFACE PkgConfig::ode)\n";
}

}  // namespace touchstone
