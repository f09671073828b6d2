#include "reports/measures/convex_polygon.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace touchstone {
namespace {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/** Returns the vector to `p` from the nearest point of a segment. */
Eigen::Vector2d OffsetFromSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                  const Eigen::Vector2d& p) {
  const Eigen::Vector2d ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return p - a - t * ab;
}

bool IsInside(std::span<const Eigen::Vector2d> hull, const Eigen::Vector2d& p) {
  bool inside = hull.size() > 2;
  for (std::size_t i = 0; i < hull.size() && inside; ++i) {
    inside = Cross(hull[(i + 1) % hull.size()] - hull[i], p - hull[i]) >= 0;
  }
  return inside;
}

}  // namespace

std::vector<Eigen::Vector2d> ConvexHullOf(std::span<const Eigen::Vector2d> points) {
  std::vector<Eigen::Vector2d> sorted(points.begin(), points.end());
  const auto less = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(sorted.begin(), sorted.end(), less);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;
  std::vector<Eigen::Vector2d> hull;
  const auto append = [&hull](const Eigen::Vector2d& p, std::size_t least) {
    while (hull.size() > least &&
           Cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Eigen::Vector2d& p : sorted) append(p, 1);
  const std::size_t lower = hull.size();
  for (auto p = sorted.rbegin() + 1; p != sorted.rend(); ++p) append(*p, lower);
  hull.pop_back();  // The first point is there twice.
  return hull;
}

double DistanceFromRim(std::span<const Eigen::Vector2d> hull, const Eigen::Vector2d& p) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    distance = std::min(
        distance, OffsetFromSegment(hull[i], hull[(i + 1) % hull.size()], p).norm());
  }
  return distance;
}

double DistanceFrom(std::span<const Eigen::Vector2d> hull, const Eigen::Vector2d& p) {
  return IsInside(hull, p) ? 0 : DistanceFromRim(hull, p);
}

Eigen::Vector2d OffsetFrom(std::span<const Eigen::Vector2d> hull,
                           const Eigen::Vector2d& p) {
  Eigen::Vector2d least = Eigen::Vector2d::Zero();
  if (IsInside(hull, p)) return least;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d offset =
        OffsetFromSegment(hull[i], hull[(i + 1) % hull.size()], p);
    if (i == 0 || offset.norm() < least.norm()) least = offset;
  }
  return least;
}

std::vector<Eigen::Vector2d> ProjectedAlong(const Eigen::Vector3d& n,
                                            std::span<const Eigen::Vector3d> points) {
  const Eigen::Vector3d u = n.unitOrthogonal();
  const Eigen::Vector3d v = n.cross(u);
  std::vector<Eigen::Vector2d> projected;
  projected.reserve(points.size());
  for (const Eigen::Vector3d& p : points) projected.emplace_back(u.dot(p), v.dot(p));
  return projected;
}

Eigen::Vector3d LiftedAcross(const Eigen::Vector3d& n, const Eigen::Vector2d& d) {
  const Eigen::Vector3d u = n.unitOrthogonal();
  return d.x() * u + d.y() * n.cross(u);
}

}  // namespace touchstone
