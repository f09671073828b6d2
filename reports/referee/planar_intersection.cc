#include "reports/referee/planar_intersection.h"

#include <algorithm>
#include <limits>

namespace touchstone::referee {
namespace {

using Eigen::Vector2d;

double Cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/** Returns the corners of the convex hull without slack, counterclockwise, by Andrew's
 monotone chain. */
Polygon StrictHull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  const auto add_chain = [&hull](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= start + 2 && Cross(hull.back() - hull[hull.size() - 2],
                                               *p - hull[hull.size() - 2]) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();  // The last point starts the other chain.
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

double DistanceFromSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d e = b - a;
  const double square = e.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(e) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * e).norm();
}

/** Clips P to the left of the line from a to b, moved outwards by `slack`. */
Polygon Clip(const Polygon& P, const Vector2d& a, const Vector2d& b, double slack) {
  const Vector2d e = (b - a).normalized();
  const auto inside = [&](const Vector2d& p) { return Cross(e, p - a) + slack; };
  Polygon kept;
  // A segment has one side, a polygon as many as corners.
  const std::size_t sides = P.size() == 2 ? 1 : P.size();
  for (std::size_t i = 0; i < sides; ++i) {
    const Vector2d& from = P[i];
    const Vector2d& to = P[(i + 1) % P.size()];
    const double s = inside(from);
    const double t = inside(to);
    if (s >= 0) kept.push_back(from);
    if ((s > 0 && t < 0) || (s < 0 && t > 0))
      kept.push_back(from + s / (s - t) * (to - from));
    if (P.size() == 2 && t >= 0) kept.push_back(to);
  }
  return kept;
}

Polygon IntersectSegments(const Polygon& P, const Polygon& Q, double slack,
                          double parallel) {
  const Vector2d e = P[1] - P[0];
  const Vector2d f = Q[1] - Q[0];
  const double turned = Cross(e, f);
  const double shorter = std::min(e.norm(), f.norm());
  if (std::abs(turned) * shorter <= parallel * e.norm() * f.norm()) {
    const Vector2d across(-e.y(), e.x());
    const Vector2d& back = e.dot(f) > 0 ? Q[0] : Q[1];
    const Vector2d& front = e.dot(f) > 0 ? Q[1] : Q[0];
    const Polygon cut = Clip(P, back + across, back, slack);
    return cut.size() < 2 ? cut : Clip(cut, front, front + across, slack);
  }
  const double t = Cross(Q[0] - P[0], f) / turned;
  return {P[0] + std::clamp(t, 0.0, 1.0) * e};
}

/** Returns the point midway between the nearest points of two disjoint polygons. One of
 the nearest points is a corner. */
Vector2d Midway(const Polygon& P, const Polygon& Q) {
  double least = std::numeric_limits<double>::infinity();
  Vector2d middle = P[0];
  const auto from_corners = [&](const Polygon& corners, const Polygon& sides) {
    for (const Vector2d& p : corners) {
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const Vector2d& a = sides[i];
        const Vector2d e = sides[(i + 1) % sides.size()] - a;
        const double square = e.squaredNorm();
        const double t = square > 0 ? std::clamp((p - a).dot(e) / square, 0.0, 1.0) : 0.0;
        const Vector2d foot = a + t * e;
        if ((p - foot).norm() < least) {
          least = (p - foot).norm();
          middle = (p + foot) / 2;
        }
      }
    }
  };
  from_corners(P, Q);
  from_corners(Q, P);
  return middle;
}

}  // namespace

Polygon HullOf(std::vector<Vector2d> points, double slack) {
  Polygon hull = StrictHull(std::move(points));
  // Dropping the least significant corner first keeps the others in place.
  while (hull.size() > 1) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t drop = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vector2d& before = hull[(i + hull.size() - 1) % hull.size()];
      const Vector2d& after = hull[(i + 1) % hull.size()];
      const double off = DistanceFromSegment(hull[i], before, after);
      if (off < least) {
        least = off;
        drop = i;
      }
    }
    if (least > slack) break;
    hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(drop));
  }
  return hull;
}

Polygon Intersect(const Polygon& P, const Polygon& Q, double slack, double parallel) {
  if (P.size() > Q.size()) return Intersect(Q, P, slack, parallel);
  if (P.size() == 1) return P;
  Polygon kept = P;
  if (Q.size() == 2) {
    kept = IntersectSegments(P, Q, slack, parallel);
  } else {
    for (std::size_t i = 0; i < Q.size() && kept.size() > 1; ++i) {
      kept = Clip(kept, Q[i], Q[(i + 1) % Q.size()], slack);
      if (P.size() > 2) kept = StrictHull(std::move(kept));
    }
  }
  if (kept.empty()) return {Midway(P, Q)};
  return HullOf(std::move(kept), slack);
}

}  // namespace touchstone::referee
