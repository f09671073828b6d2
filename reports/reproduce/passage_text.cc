#include "reports/reproduce/passage_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"

namespace touchstone {
namespace {

/** Cross products of unit vectors that are shorter are of parallel ones. [-] */
constexpr double kParallel = 1e-9;

const RigidBody& BodyAt(const World& world, int index) {
  return world.bodies[static_cast<std::size_t>(index)];
}

constexpr const char* kLine = R"(
// How far the sphere must leave the straight line through its centres at two times to pass
// the other body, which does not move.
double Passage(const WorldState& from, const WorldState& to) {{
  const Vector& a = from[{A}].p;
  const Vector& b = to[{A}].p;
  const Vector& o = kBodies[{B}].p;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const Vector d = {{(b[0] - a[0]) / length, (b[1] - a[1]) / length,
                    (b[2] - a[2]) / length}};
  const Vector c = {{a[0] - o[0], a[1] - o[1], a[2] - o[2]}};
{rest}}}
)";

constexpr const char* kToSphere =
    R"(  const double along = c[0] * d[0] + c[1] * d[1] + c[2] * d[2];
  return {a} + {b} - std::hypot(c[0] - along * d[0], c[1] - along * d[1],
                                c[2] - along * d[2]);
)";

constexpr const char* kToBox =
    R"(  // Seen along the line the box is a hexagon, whose normals are d x its axes.
  const Matrix& R = kBodies[{B}].R;
  const Vector half = {{{b}}};
  double least = INFINITY;
  for (int i = 0; i < 3; ++i) {{
    Vector n = {{d[1] * R[i + 6] - d[2] * R[i + 3], d[2] * R[i] - d[0] * R[i + 6],
                d[0] * R[i + 3] - d[1] * R[i]}};
    const double norm = std::hypot(n[0], n[1], n[2]);
    if (norm < 1e-9) continue;
    double overlap = -std::abs(n[0] * c[0] + n[1] * c[1] + n[2] * c[2]);
    for (int k = 0; k < 3; ++k)
      overlap += half[k] * std::abs(n[0] * R[k] + n[1] * R[k + 3] + n[2] * R[k + 6]);
    least = std::min(least, overlap / norm);
  }}
  return {a} + least;
)";

}  // namespace

bool HasPassage(const World& world, int A, int B) {
  const Shape& other = BodyAt(world, B).placed.shape;
  return std::holds_alternative<Sphere>(BodyAt(world, A).placed.shape) &&
         BodyAt(world, B).mass == 0 &&
         (std::holds_alternative<Sphere>(other) || std::holds_alternative<Box>(other));
}

double PassageOf(const World& world, const WorldState& from, const WorldState& to, int A,
                 int B) {
  const auto index = static_cast<std::size_t>(A);
  const Body& other = BodyAt(world, B).placed;
  const Eigen::Vector3d c = from.bodies[index].p_WB - other.X_WB.p_WB;
  const Eigen::Vector3d d =
      (to.bodies[index].p_WB - from.bodies[index].p_WB).normalized();
  const double radius = std::get<Sphere>(BodyAt(world, A).placed.shape).radius;
  if (const auto* const sphere = std::get_if<Sphere>(&other.shape))
    return radius + sphere->radius - (c - c.dot(d) * d).norm();
  const Eigen::Vector3d& half = std::get<Box>(other.shape).half_extents;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d n = d.cross(Eigen::Vector3d(other.X_WB.R_WB.col(i)));
    if (n.norm() < kParallel) continue;
    const double reach = (other.X_WB.R_WB.transpose() * n).cwiseAbs().dot(half);
    least = std::min(least, (reach - std::abs(n.dot(c))) / n.norm());
  }
  return radius + least;
}

std::string PassageText(const World& world, int A, int B) {
  const double radius = std::get<Sphere>(BodyAt(world, A).placed.shape).radius;
  const Shape& other = BodyAt(world, B).placed.shape;
  const auto* const box = std::get_if<Box>(&other);
  const std::string size = box != nullptr ? Literals(box->half_extents)
                                          : Literal(std::get<Sphere>(other).radius);
  const std::string rest =
      fmt::format(fmt::runtime(box != nullptr ? kToBox : kToSphere), fmt::arg("A", A),
                  fmt::arg("B", B), fmt::arg("a", Literal(radius)), fmt::arg("b", size));
  return fmt::format(kLine, fmt::arg("A", A), fmt::arg("B", B), fmt::arg("rest", rest));
}

}  // namespace touchstone
