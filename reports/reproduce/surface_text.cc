#include "reports/reproduce/surface_text.h"

#include <optional>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "scenarios/convex_facets.h"

namespace touchstone {
namespace {

// The distance from a polyhedron: inside it the largest height above a face's plane,
// outside it the least distance from a face.
constexpr const char* kHull = R"(  struct Face {{
    Vector n;  // Outward unit normal.
    double offset;  // n·x of its plane.
    std::vector<Vector> corners;  // Counterclockwise, seen from outside.
  }};
  static const std::vector<Face> faces = {{{}
  }};
  const Vector p = {{x, y, z}};
  const auto minus = [](const Vector& u, const Vector& v) {{
    return Vector{{u[0] - v[0], u[1] - v[1], u[2] - v[2]}};
  }};
  const auto dot = [](const Vector& u, const Vector& v) {{
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }};
  const auto cross = [](const Vector& u, const Vector& v) {{
    return Vector{{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                  u[0] * v[1] - u[1] * v[0]}};
  }};
  double highest = -INFINITY, nearest = INFINITY;
  for (const Face& face : faces) {{
    const double height = dot(face.n, p) - face.offset;
    highest = std::max(highest, height);
    bool is_above = true;
    double from_rim = INFINITY;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {{
      const Vector& a = face.corners[i];
      const Vector side = minus(face.corners[(i + 1) % face.corners.size()], a);
      const Vector arm = minus(p, a);
      if (dot(cross(face.n, side), arm) < 0) is_above = false;
      const double t = std::clamp(dot(arm, side) / dot(side, side), 0.0, 1.0);
      const Vector off = {{arm[0] - t * side[0], arm[1] - t * side[1], arm[2] - t * side[2]}};
      from_rim = std::min(from_rim, std::hypot(off[0], off[1], off[2]));
    }}
    nearest = std::min(nearest, is_above ? std::abs(height) : from_rim);
  }}
  return highest <= 0 ? highest : nearest;
)";

/** Writes the signed distance of the point (x, y, z) of the body's frame. */
struct Distance {
  std::string operator()(const Sphere& s) const {
    return fmt::format("  return std::hypot(x, y, z) - {};\n", Literal(s.radius));
  }
  std::string operator()(const Box& s) const {
    return fmt::format(
        "  const double a = std::abs(x) - {};\n  const double b = std::abs(y) - {};\n"
        "  const double c = std::abs(z) - {};\n"
        "  if (a <= 0 && b <= 0 && c <= 0) return std::max({{a, b, c}});\n"
        "  return std::hypot(std::max(a, 0.0), std::max(b, 0.0), std::max(c, 0.0));\n",
        Literal(s.half_extents.x()), Literal(s.half_extents.y()),
        Literal(s.half_extents.z()));
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format("  return std::hypot(x, y, z - std::clamp(z, -{1}, {1})) - {0};\n",
                       Literal(s.radius), Literal(s.half_length));
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format(
        "  const double a = std::hypot(x, y) - {};\n"
        "  const double b = std::abs(z) - {};\n"
        "  if (a <= 0 && b <= 0) return std::max(a, b);\n"
        "  return std::hypot(std::max(a, 0.0), std::max(b, 0.0));\n",
        Literal(s.radius), Literal(s.half_length));
  }
  std::string operator()(const Cone& s) const {
    // In the half-plane of the axis the cone is a triangle: the base from (0, -h) to
    // (r, -h), and the side from there to the apex (0, h).
    return fmt::format(
        "  const double r = {};\n  const double h = {};\n"
        "  const double rho = std::hypot(x, y);\n"
        "  const double slant = std::hypot(r, 2 * h);\n"
        "  const double above_side = (2 * h * rho + r * (z - h)) / slant;\n"
        "  const double above_base = -h - z;\n"
        "  if (above_side <= 0 && above_base <= 0) return std::max(above_side, "
        "above_base);\n"
        "  const double t = std::clamp((r * (r - rho) + 2 * h * (z + h)) / (slant * "
        "slant), 0.0, 1.0);\n"
        "  return std::min(std::hypot(rho - r * (1 - t), z + h - 2 * h * t),\n"
        "                  std::hypot(std::max(rho - r, 0.0), z + h));\n",
        Literal(s.radius), Literal(s.half_height));
  }
  std::string operator()(const ConvexHull& s) const {
    const std::optional<ConvexFacets> boundary = BoundaryOf(s);
    if (!boundary)
      throw CannotReproduce("the hull is flat: a program needs its faces for distances");
    std::string faces;
    for (const ConvexFacet& facet : boundary->facets) {
      std::string corners;
      for (const int corner : facet.corners) {
        corners +=
            fmt::format("{}\n        {{{}}}", corners.empty() ? "" : ",",
                        Literals(boundary->corners[static_cast<std::size_t>(corner)]));
      }
      faces += fmt::format("\n      {{{{{}}}, {}, {{{}}}}},", Literals(facet.n_B),
                           Literal(facet.offset), corners);
    }
    return fmt::format(kHull, faces);
  }
  std::string operator()(const HalfSpace&) const {
    return "  (void)x;\n  (void)y;\n  return z;\n";
  }
};

}  // namespace

std::string SignedDistanceText(char name, const Body& body) {
  return fmt::format(
      "\n// The signed distance of a point from the surface of {0}, negative inside.\n"
      "double From{0}(const Vector& point) {{\n"
      "  auto [u, v, w] = point;\n  // The point in the frame of {0}.\n{1}{2}}}\n",
      name, InBodyFrame(body.X_WB), std::visit(Distance{}, body.shape));
}

std::string SignedDistancesText(const ContactQuery& query) {
  return SignedDistanceText('A', query.A) + SignedDistanceText('B', query.B);
}

}  // namespace touchstone
