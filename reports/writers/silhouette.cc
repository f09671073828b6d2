#include "reports/writers/silhouette.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace touchstone {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Half width of the square to which lines are clipped. It is larger than the picture, so
// that the clipped sides of an outline lie outside the picture.
constexpr double kBorder = 1.1;

double Cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Convex hull by Andrew's monotone chain.
Polyline ConvexHullOf(Polyline points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Polyline hull;
  const auto extend = [&hull](const Vector2d& point, std::size_t floor) {
    while (hull.size() >= floor + 2 &&
           Cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Vector2d& point : points) extend(point, 0);
  const std::size_t upper = hull.empty() ? 0 : hull.size() - 1;
  for (auto point = points.rbegin(); point != points.rend(); ++point)
    extend(*point, upper);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

// The corners of a box, body frame.
std::vector<Vector3d> CornersOf(const Box& box) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3d sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    corners.push_back(box.half_extents.cwiseProduct(sign));
  }
  return corners;
}

Vector3d RimPoint(double radius, double z, const Vector3d& direction_B) {
  const double radial = std::hypot(direction_B.x(), direction_B.y());
  if (radial == 0) return {radius, 0, z};
  return {radius * direction_B.x() / radial, radius * direction_B.y() / radial, z};
}

// The farthest point of a curved shape along a unit direction, body frame.
Vector3d SupportOf(const Sphere& sphere, const Vector3d& d_B) {
  return sphere.radius * d_B;
}
Vector3d SupportOf(const Capsule& capsule, const Vector3d& d_B) {
  return capsule.radius * d_B +
         Vector3d(0, 0, std::copysign(capsule.half_length, d_B.z()));
}
Vector3d SupportOf(const Cylinder& cylinder, const Vector3d& d_B) {
  return RimPoint(cylinder.radius, std::copysign(cylinder.half_length, d_B.z()), d_B);
}
Vector3d SupportOf(const Cone& cone, const Vector3d& d_B) {
  const Vector3d apex(0, 0, cone.half_height);
  const Vector3d rim = RimPoint(cone.radius, -cone.half_height, d_B);
  return d_B.dot(apex) > d_B.dot(rim) ? apex : rim;
}

// Angles of samples around the outline: evenly spaced, and in steps that halve towards
// ±n. A picture magnified 2^k there shows only the outline within about 2^-k of these
// angles.
std::vector<double> OutlineAngles(double angle_of_n) {
  constexpr int kEven = 72;
  constexpr int kHalvings = 40;
  std::vector<double> angles;
  for (int i = 0; i < kEven; ++i) angles.push_back(2 * std::numbers::pi * i / kEven);
  for (const double pole : {angle_of_n, angle_of_n + std::numbers::pi}) {
    angles.push_back(pole);
    for (int k = 4; k < kHalvings; ++k) {
      for (const double step : {1.0, 1.25, 1.5, 1.75}) {
        angles.push_back(pole + std::ldexp(step, -k));
        angles.push_back(pole - std::ldexp(step, -k));
      }
    }
  }
  return angles;
}

struct Outline {
  const Pose& X_WB;
  const View& view;
  const Vector3d& n_W;

  template <typename Curved>
  Polyline operator()(const Curved& shape) const {
    const double angle_of_n = std::atan2(view.up_W.dot(n_W), view.right_W.dot(n_W));
    Polyline points;
    for (const double angle : OutlineAngles(angle_of_n)) {
      const Vector3d d_W = std::cos(angle) * view.right_W + std::sin(angle) * view.up_W;
      const Vector3d d_B = X_WB.R_WB.transpose() * d_W;
      points.push_back(view * (X_WB * SupportOf(shape, d_B)));
    }
    return ConvexHullOf(std::move(points));
  }

  Polyline operator()(const Box& box) const { return HullOf(CornersOf(box)); }
  Polyline operator()(const ConvexHull& hull) const { return HullOf(hull.vertices); }

  Polyline operator()(const HalfSpace&) const {
    const Vector3d m_W = X_WB.R_WB.col(2);
    const Vector2d m(view.right_W.dot(m_W), view.up_W.dot(m_W));
    constexpr double kFar = 4;  // Covers the picture from any edge through it.
    // Only an edge-on view (normal in the plane of the picture) shows an edge; any other
    // view is filled.
    if (m.norm() < 0.5)
      return {{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}};
    const double height = m_W.dot(view.centre_W - X_WB.p_WB) / view.half_width;
    const Vector2d up = m.normalized();
    const Vector2d along(-up.y(), up.x());
    const Vector2d foot = -height * up;
    return {foot + kFar * along, foot + kFar * along - 2 * kFar * up,
            foot - kFar * along - 2 * kFar * up, foot - kFar * along};
  }

 private:
  Polyline HullOf(const std::vector<Vector3d>& vertices_B) const {
    Polyline points;
    for (const Vector3d& vertex : vertices_B) points.push_back(view * (X_WB * vertex));
    return ConvexHullOf(std::move(points));
  }
};

struct InnerLines {
  const Pose& X_WB;
  const View& view;

  template <typename Plain>
  std::vector<Polyline> operator()(const Plain&) const {
    return {};
  }

  // An edge inside the outline belongs to two faces that both face the viewer. At most
  // three edges do, and they meet in the corner nearest to the viewer.
  std::vector<Polyline> operator()(const Box& box) const {
    const Vector3d viewer_B = X_WB.R_WB.transpose() * view.right_W.cross(view.up_W);
    Vector3d nearest = box.half_extents;
    for (int i = 0; i < 3; ++i) nearest[i] = std::copysign(nearest[i], viewer_B[i]);
    std::vector<Polyline> edges;
    for (int i = 0; i < 3; ++i) {
      Vector3d other = nearest;
      other[i] = -other[i];
      edges.push_back({view * (X_WB * nearest), view * (X_WB * other)});
    }
    return edges;
  }

  std::vector<Polyline> operator()(const Cylinder& cylinder) const {
    return {Rim(cylinder.radius, cylinder.half_length),
            Rim(cylinder.radius, -cylinder.half_length)};
  }
  std::vector<Polyline> operator()(const Cone& cone) const {
    return {Rim(cone.radius, -cone.half_height)};
  }

 private:
  Polyline Rim(double radius, double z) const {
    constexpr int kSamples = 48;
    Polyline rim;
    for (int i = 0; i <= kSamples; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSamples;
      const Vector3d p_B(radius * std::cos(angle), radius * std::sin(angle), z);
      rim.push_back(view * (X_WB * p_B));
    }
    return rim;
  }
};

// Part of the segment inside the picture with border (Liang and Barsky), if any.
std::optional<std::pair<Vector2d, Vector2d>> ClipSegment(const Vector2d& a,
                                                         const Vector2d& b) {
  double enter = 0;
  double leave = 1;
  const Vector2d step = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const double speed = side * step[axis];
      const double room = kBorder - side * a[axis];
      if (speed == 0) {
        if (room < 0) return std::nullopt;
      } else if (speed > 0) {
        leave = std::min(leave, room / speed);
      } else {
        enter = std::max(enter, room / speed);
      }
    }
  }
  if (enter > leave) return std::nullopt;
  return std::pair<Vector2d, Vector2d>(a + enter * step, a + leave * step);
}

}  // namespace

Polyline OutlineOf(const Body& body, const View& view, const Eigen::Vector3d& n_W) {
  return std::visit(Outline{body.X_WB, view, n_W}, body.shape);
}

std::vector<Polyline> InnerLinesOf(const Body& body, const View& view) {
  return std::visit(InnerLines{body.X_WB, view}, body.shape);
}

// Sutherland-Hodgman clipping: cuts by one side of the picture after the other.
Polyline ClipToPicture(const Polyline& outline) {
  Polyline polygon = outline;
  for (int axis = 0; axis < 2; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Polyline kept;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d& here = polygon[i];
        const Vector2d& next = polygon[(i + 1) % polygon.size()];
        const double room_here = kBorder - side * here[axis];
        const double room_next = kBorder - side * next[axis];
        if (room_here >= 0) kept.push_back(here);
        if ((room_here >= 0) != (room_next >= 0)) {
          kept.push_back(here + (next - here) * (room_here / (room_here - room_next)));
        }
      }
      polygon = std::move(kept);
    }
  }
  return polygon;
}

std::vector<Polyline> ClipLineToPicture(const Polyline& line) {
  std::vector<Polyline> parts;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto segment = ClipSegment(line[i], line[i + 1]);
    if (!segment) continue;
    if (!parts.empty() && parts.back().back() == segment->first) {
      parts.back().push_back(segment->second);
    } else {
      parts.push_back({segment->first, segment->second});
    }
  }
  return parts;
}

}  // namespace touchstone
