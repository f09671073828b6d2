#include <cmath>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/midway_text.h"
#include "reports/reproduce/ode_text.h"

namespace touchstone {
namespace {

std::string BodyText(char name, const Body& body) {
  const Eigen::Matrix3d& R = body.X_WB.R_WB;
  const Eigen::Vector3d& p = body.X_WB.p_WB;
  if (std::holds_alternative<HalfSpace>(body.shape)) {
    const Eigen::Vector3d n = R.col(2);
    return fmt::format("  const dGeomID {} = dCreatePlane(nullptr, {}, {});\n", name,
                       Literals(n), Literal(n.dot(p)));
  }
  const auto row = [&](int i) { return Literals(Eigen::Vector3d(R.row(i))); };
  std::string created;
  Eigen::Vector3d origin_W = p;
  if (const auto* hull = std::get_if<ConvexHull>(&body.shape)) {
    const OdeConvex convex = OdeConvexOf(name, *hull);
    created = convex.definition;
    origin_W = p + R * convex.origin_B;
  } else {
    created = fmt::format("  const dGeomID {} = {};\n", name, OdeShape(body.shape));
  }
  return created + fmt::format(
                       "  const dMatrix3 R_{0} = {{{1}, 0,\n      {2}, 0,\n      {3}, "
                       "0}};\n"
                       "  dGeomSetRotation({0}, R_{0});\n"
                       "  dGeomSetPosition({0}, {4});\n",
                       name, row(0), row(1), row(2), Literals(origin_W));
}

bool Is(const Body& body, ShapeKind kind) {
  return KindOf(body.shape) == kind;
}

bool Either(const ContactQuery& query, ShapeKind kind) {
  return Is(query.A, kind) || Is(query.B, kind);
}

/** The shift from dContactGeom::pos to midway, see the table in
 oracles/ode/ode_contact_point.h. */
struct Shift {
  std::string expression;  ///< Of `c`, `n` and `half`.
  bool is_best = false;    ///< Whether it calls BestShift().
};

constexpr const char* kBest =
    "BestShift({{{}}}, {{c.pos[0], c.pos[1], c.pos[2]}}, n, c.depth)";

/** The shift for two cylinders. ODE has a special case for two discs on each other, whose
 normal is one of the axes, and puts the contacts of others somewhere in the overlap. */
Shift ShiftOfCylinders(const ContactQuery& query) {
  const Eigen::Vector3d a = query.A.X_WB.R_WB.col(2);
  const Eigen::Vector3d b = query.B.X_WB.R_WB.col(2);
  // ODE's own condition; see IsDiscOnDisc() of the adapter.
  if (!(1 - std::abs(a.dot(b)) < 1e-3)) return {"0", false};
  const auto along = [](const Eigen::Vector3d& axis) {
    return fmt::format("std::abs({} * n[0] + {} * n[1] + {} * n[2])", Literal(axis.x()),
                       Literal(axis.y()), Literal(axis.z()));
  };
  return {fmt::format("1 - std::max({}, {}) < 1e-12 ? {} : 0.0", along(a), along(b),
                      fmt::format(kBest, "0.0, -half, half")),
          true};
}

Shift ShiftOf(const ContactQuery& query) {
  if (Is(query.B, ShapeKind::kHalfSpace)) return {"-half", false};
  if (Is(query.A, ShapeKind::kHalfSpace)) return {"half", false};
  if (Either(query, ShapeKind::kConvexHull)) return {"0", false};
  if (Either(query, ShapeKind::kSphere)) {
    if (Either(query, ShapeKind::kBox)) return {ShiftOfSphereAtBox(query), false};
    const bool first = Is(query.A, ShapeKind::kSphere);
    const Shape& other = first ? query.B.shape : query.A.shape;
    const auto* const cylinder = std::get_if<Cylinder>(&other);
    if (cylinder == nullptr) return {"0", false};
    const std::string from_axis = fmt::format(
        fmt::runtime(first ? "half - {}" : "-(half - {})"), Literal(cylinder->radius));
    return {fmt::format(kBest, "-half, half, " + from_axis), true};
  }
  if (Either(query, ShapeKind::kBox))
    return {fmt::format(kBest, "0.0, -half, half"), true};
  if (Is(query.A, ShapeKind::kCylinder) && Is(query.B, ShapeKind::kCylinder))
    return ShiftOfCylinders(query);
  return {"0", false};
}

constexpr const char* kAsk = R"(
  dContactGeom contacts[8];
  const int count = dCollide(A, B, 8, contacts, sizeof(dContactGeom));
  std::printf("dCollide: %d contacts\n", count);
  Answer answer;
  answer.touching = count > 0;
  for (int i = 0; i < count; ++i) {{
    const dContactGeom& c = contacts[i];
    std::printf("contact %d: depth %.17g, normal (%.17g, %.17g, %.17g), "
                "pos (%.17g, %.17g, %.17g)\n", i, c.depth, c.normal[0], c.normal[1],
                c.normal[2], c.pos[0], c.pos[1], c.pos[2]);
    // ODE's normal points from the second geom to the first.
    const Vector n = {{-c.normal[0], -c.normal[1], -c.normal[2]}};
    const double half = c.depth / 2;
    const double shift = {};  // From where ODE puts a contact of this pair to midway.
    answer.contacts.push_back({{{{c.pos[0] + shift * n[0], c.pos[1] + shift * n[1],
                                c.pos[2] + shift * n[2]}}, -c.depth, n}});
    if (i > 0 && !(-c.depth < answer.separation)) continue;
    answer.separation = -c.depth;
    answer.n = n;
  }}
  return answer;
)";

}  // namespace

EngineCode OdeCode(const ContactQuery& query, const std::string&) {
  EngineCode code;
  code.includes = "#include <ode/ode.h>\n";
  const Shift shift = ShiftOf(query);
  if (shift.is_best) code.definitions = BestShiftText(query);
  code.ask = "  dInitODE2(0);\n" + BodyText('A', query.A) + BodyText('B', query.B) +
             fmt::format(kAsk, shift.expression);
  code.find = FindOde();
  code.call = "dCollide on two geoms, up to 8 contacts";
  code.package = "libode-dev";
  return code;
}

}  // namespace touchstone
