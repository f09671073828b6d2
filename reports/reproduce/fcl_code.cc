#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "scenarios/convex_facets.h"

namespace touchstone {
namespace {

struct Construct {
  std::string operator()(const Sphere& s) const {
    return fmt::format("fcl::Sphered({})", Literal(s.radius));
  }
  std::string operator()(const Box& s) const {
    return fmt::format("fcl::Boxd({})", Literals(Eigen::Vector3d(2 * s.half_extents)));
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format("fcl::Capsuled({}, {})", Literal(s.radius),
                       Literal(2 * s.half_length));
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format("fcl::Cylinderd({}, {})", Literal(s.radius),
                       Literal(2 * s.half_length));
  }
  std::string operator()(const Cone& s) const {
    return fmt::format("fcl::Coned({}, {})", Literal(s.radius),
                       Literal(2 * s.half_height));
  }
  std::string operator()(const ConvexHull& s) const {
    const std::optional<ConvexFacets> boundary = BoundaryOf(s);
    if (!boundary) throw CannotReproduce("the hull is flat, and FCL needs its faces");
    std::string corners;
    for (const Eigen::Vector3d& corner : boundary->corners)
      corners += fmt::format("\n      {{{}}},", Literals(corner));
    std::string faces;
    for (const ConvexFacet& facet : boundary->facets) {
      faces += fmt::format("\n      {},", facet.corners.size());
      for (const int corner : facet.corners) faces += fmt::format(" {},", corner);
    }
    return fmt::format(
        "fcl::Convexd(std::make_shared<const std::vector<fcl::Vector3d>>(\n"
        "      std::vector<fcl::Vector3d>{{{}}}), {},\n"
        "      std::make_shared<const std::vector<int>>(std::vector<int>{{{}}}))",
        corners, boundary->facets.size(), faces);
  }
  std::string operator()(const HalfSpace&) const {
    return "fcl::Halfspaced(fcl::Vector3d::UnitZ(), 0.0)";
  }
};

std::string BodyText(char name, const Body& body) {
  return fmt::format(
      "  const auto {0} = {1};\n"
      "  fcl::Transform3d X_{0} = fcl::Transform3d::Identity();\n"
      "  X_{0}.linear() << {2};\n"
      "  X_{0}.translation() << {3};\n",
      name, std::visit(Construct{}, body.shape), Literals(body.X_WB.R_WB),
      Literals(body.X_WB.p_WB));
}

constexpr const char* kCollide = R"(
  fcl::CollisionRequestd request;
  request.num_max_contacts = 8;
  request.enable_contact = true;
  request.gjk_solver_type = fcl::{0};
  request.gjk_tolerance = 1e-6;
  fcl::CollisionResultd result;
  fcl::collide(&A, X_A, &B, X_B, request, result);
  Answer answer;
  answer.touching = result.isCollision();
  std::printf("fcl::collide: %s, contacts: %zu\n",
              answer.touching ? "collision" : "no collision", result.numContacts());
  for (std::size_t i = 0; i < result.numContacts(); ++i) {{
    const fcl::Contactd& c = result.getContact(i);
    std::printf("contact %zu: penetration_depth %.17g, normal (%.17g, %.17g, %.17g), "
                "pos (%.17g, %.17g, %.17g)\n", i, c.penetration_depth, c.normal[0],
                c.normal[1], c.normal[2], c.pos[0], c.pos[1], c.pos[2]);
    const double shift = {1};
    Contact contact;
    contact.s = -c.penetration_depth;
    for (int k = 0; k < 3; ++k) {{
      contact.n[k] = c.normal[k];
      contact.p[k] = c.pos[k] + shift * c.normal[k];
    }}
    answer.contacts.push_back(contact);
    if (i > 0 && !(-c.penetration_depth < answer.separation)) continue;
    answer.separation = -c.penetration_depth;
    answer.n = {{c.normal[0], c.normal[1], c.normal[2]}};
  }}
  return answer;
)";

/** Writes the shift from Contact::pos to midway, see oracles/fcl/fcl_contact_point.h. */
std::string ShiftText(const ContactQuery& query) {
  const auto* const A = std::get_if<Sphere>(&query.A.shape);
  const auto* const B = std::get_if<Sphere>(&query.B.shape);
  if (A == nullptr || B == nullptr) return "0";
  return fmt::format(
      "({0} / ({0} + {1}) - 0.5) * c.penetration_depth;  // FCL weights by the radii",
      Literal(A->radius), Literal(B->radius));
}

constexpr const char* kDistance = R"(
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  request.enable_signed_distance = {1};
  request.gjk_solver_type = fcl::{0};
  request.distance_tolerance = {2};
  fcl::DistanceResultd result;
  fcl::distance(&A, X_A, &B, X_B, request, result);
  const fcl::Vector3d& a = result.nearest_points[0];
  const fcl::Vector3d& b = result.nearest_points[1];
  std::printf("fcl::distance: min_distance %.17g\n", result.min_distance);
  std::printf("nearest_points[0] (%.17g, %.17g, %.17g)\n", a[0], a[1], a[2]);
  std::printf("nearest_points[1] (%.17g, %.17g, %.17g)\n", b[0], b[1], b[2]);
  Answer answer;
  answer.separation = result.min_distance;
  answer.touching = answer.separation <= 0;
  answer.a = {{a[0], a[1], a[2]}};
  answer.b = {{b[0], b[1], b[2]}};
  const double sign = answer.separation > 0 ? 1 : -1;
  const double length = (b - a).norm();
  for (int i = 0; i < 3; ++i) answer.n[i] = sign * (b[i] - a[i]) / length;
  return answer;
)";

}  // namespace

EngineCode FclCode(const ContactQuery& query, const std::string& oracle) {
  const bool indep = oracle.ends_with("_indep");
  const char* const solver = indep ? "GST_INDEP" : "GST_LIBCCD";
  const std::string bodies = BodyText('A', query.A) + BodyText('B', query.B);
  EngineCode code;
  code.find =
      "find_package(fcl REQUIRED)\nadd_library(engine INTERFACE)\n"
      "target_link_libraries(engine INTERFACE fcl)\n";
  code.package = "libfcl-dev";
  if (oracle.starts_with("fcl/collide")) {
    code.includes = "#include <fcl/fcl.h>\n#include <fcl/narrowphase/collision.h>\n";
    code.ask = bodies + fmt::format(kCollide, solver, ShiftText(query));
    code.call = fmt::format(
        "fcl::collide with gjk_solver_type {}, gjk_tolerance 1e-6 (the default), 8 "
        "contacts",
        solver);
    return code;
  }
  const bool is_signed = oracle.starts_with("fcl/signed_distance");
  const char* const tolerance = !indep && !is_signed ? "1e-12" : "1e-6";
  code.includes = "#include <fcl/fcl.h>\n#include <fcl/narrowphase/distance.h>\n";
  code.ask =
      bodies + fmt::format(kDistance, solver, is_signed ? "true" : "false", tolerance);
  code.call = fmt::format(
      "fcl::distance with gjk_solver_type {}, enable_signed_distance {}, "
      "distance_tolerance {}",
      solver, is_signed ? "true" : "false", tolerance);
  return code;
}

}  // namespace touchstone
