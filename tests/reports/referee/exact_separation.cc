#include "tests/reports/referee/exact_separation.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace touchstone {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_3;

std::vector<Eigen::Vector3d> CornersOf(const Shape& shape) {
  if (const auto* hull = std::get_if<ConvexHull>(&shape)) return hull->vertices;
  std::vector<Eigen::Vector3d> corners;
  const Eigen::Vector3d& h = std::get<Box>(shape).half_extents;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back(i & 1 ? h.x() : -h.x(), i & 2 ? h.y() : -h.y(),
                         i & 4 ? h.z() : -h.z());
  }
  return corners;
}

std::vector<Point> PlacedCorners(const Body& body) {
  const Eigen::Matrix3d& R = body.X_WB.R_WB;
  const Eigen::Vector3d& p = body.X_WB.p_WB;
  std::vector<Point> placed;
  for (const Eigen::Vector3d& q : CornersOf(body.shape)) {
    const auto coordinate = [&](int i) {
      return Number(R(i, 0)) * Number(q.x()) + Number(R(i, 1)) * Number(q.y()) +
             Number(R(i, 2)) * Number(q.z()) + Number(p[i]);
    };
    placed.emplace_back(coordinate(0), coordinate(1), coordinate(2));
  }
  return placed;
}

/** The exact separation as its sign and its square. */
struct SignedSquare {
  bool apart;
  Number square;
};

SignedSquare Separation(const ContactQuery& query) {
  std::vector<Point> differences;
  const std::vector<Point> corners_B = PlacedCorners(query.B);
  for (const Point& a : PlacedCorners(query.A)) {
    for (const Point& b : corners_B) differences.push_back(CGAL::ORIGIN + (a - b));
  }
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(differences.begin(), differences.end(), hull);

  const Point origin(0, 0, 0);
  bool apart = false;
  std::optional<Number> depth;
  std::optional<Number> distance;
  for (const auto face : hull.faces()) {
    std::vector<Point> x;
    for (const auto v : CGAL::vertices_around_face(hull.halfedge(face), hull)) {
      x.push_back(hull.point(v));
    }
    if (x.size() != 3) throw std::logic_error("a hull is triangulated");
    const Kernel::Plane_3 plane(x[0], x[1], x[2]);
    apart = apart || plane.has_on_positive_side(origin);
    const Number to_plane = CGAL::squared_distance(origin, plane);
    const Number to_face =
        CGAL::squared_distance(origin, Kernel::Triangle_3(x[0], x[1], x[2]));
    if (!depth || to_plane < *depth) depth = to_plane;
    if (!distance || to_face < *distance) distance = to_face;
  }
  return {apart, apart ? *distance : *depth};
}

/** Returns whether bound <= the exact separation, or >= if `sense` is -1. */
bool Below(const Number& bound, const SignedSquare& exact, int sense) {
  const int sign = (exact.apart ? 1 : -1) * sense;
  const Number b = bound * Number(sense);
  if (sign > 0) return b <= Number(0) || b * b <= exact.square;
  return b <= Number(0) && b * b >= exact.square;
}

}  // namespace

ExactComparison CompareExactly(const ContactQuery& query, const Enclosure& separation) {
  const SignedSquare exact = Separation(query);
  const double size = std::sqrt(CGAL::to_double(exact.square));
  return {Below(Number(separation.lo), exact, 1), Below(Number(separation.hi), exact, -1),
          exact.apart ? size : -size};
}

}  // namespace touchstone
