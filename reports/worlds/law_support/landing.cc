#include "reports/worlds/law_support/landing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "scenarios/convex_facets.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/** Largest sine of the angle between a face and the plane it lies on: that of a pose in
 single precision, or with eight digits. */
constexpr double kFlat = 3e-7;

/** A plane that never moves. */
struct Plane {
  Eigen::Vector3d n_W;
  Eigen::Vector3d p_W;
};

std::optional<Plane> PlaneUnder(const Body& ground, const Eigen::Vector3d& p_W) {
  const Eigen::Matrix3d& R = ground.X_WB.R_WB;
  if (std::holds_alternative<HalfSpace>(ground.shape))
    return Plane{R.col(2), ground.X_WB.p_WB};
  const auto* box = std::get_if<Box>(&ground.shape);
  if (!box) return std::nullopt;
  const Eigen::Vector3d p_B = R.transpose() * (p_W - ground.X_WB.p_WB);
  int axis = 0;
  (p_B.cwiseAbs() - box->half_extents).maxCoeff(&axis);
  for (int other = 0; other < 3; ++other) {
    if (other != axis && std::abs(p_B[other]) > box->half_extents[other])
      return std::nullopt;
  }
  const double side = p_B[axis] < 0 ? -1 : 1;
  return Plane{side * R.col(axis),
               ground.X_WB.p_WB + side * box->half_extents[axis] * R.col(axis)};
}

/** Returns the farthest point of a shape along d_B. Body frame. [m] */
struct Farthest {
  Vector3d d_B;

  /** The farthest point of a disc of that radius across the z axis, about the origin. */
  Vector3d OnDisc(double radius) const {
    const Vector3d out(d_B.x(), d_B.y(), 0);
    return out.isZero(0) ? out : Vector3d(radius * out.normalized());
  }

  Vector3d operator()(const Sphere& s) const { return s.radius * d_B.normalized(); }
  Vector3d operator()(const Box& s) const {
    Vector3d corner;
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] = std::copysign(s.half_extents[axis], d_B[axis]);
    return corner;
  }
  Vector3d operator()(const Capsule& s) const {
    return Vector3d(0, 0, std::copysign(s.half_length, d_B.z())) +
           s.radius * d_B.normalized();
  }
  Vector3d operator()(const Cylinder& s) const {
    return OnDisc(s.radius) + Vector3d(0, 0, std::copysign(s.half_length, d_B.z()));
  }
  Vector3d operator()(const Cone& s) const {
    const Vector3d apex(0, 0, s.half_height);
    const Vector3d rim = OnDisc(s.radius) - apex;
    return d_B.dot(apex) > d_B.dot(rim) ? apex : rim;
  }
  Vector3d operator()(const ConvexHull& s) const {
    return *std::ranges::max_element(
        s.vertices, {}, [this](const Vector3d& vertex) { return d_B.dot(vertex); });
  }
  Vector3d operator()(const HalfSpace&) const { return Vector3d::Zero(); }
};

/** See LiesFlat(). */
struct IsFlat {
  Vector3d down_B;  ///< Unit vector.

  // The sine, not the cosine: that of a tilt of 4e-5 is 1 to 1e-9.
  bool IsAlong(const Vector3d& axis_B) const {
    return down_B.cross(axis_B).norm() <= kFlat;
  }
  bool IsAlongAxis() const { return IsAlong(Vector3d::UnitZ()); }
  bool IsAcrossAxis() const { return std::abs(down_B.z()) <= kFlat; }

  bool operator()(const Sphere&) const { return true; }
  bool operator()(const Box&) const {
    return IsAlong(Vector3d::UnitX()) || IsAlong(Vector3d::UnitY()) || IsAlongAxis();
  }
  bool operator()(const Capsule&) const { return IsAcrossAxis(); }
  bool operator()(const Cylinder&) const { return IsAlongAxis() || IsAcrossAxis(); }
  bool operator()(const Cone&) const { return down_B.z() < 0 && IsAlongAxis(); }
  bool operator()(const ConvexHull& s) const {
    const std::optional<ConvexFacets> boundary = BoundaryOf(s);
    return boundary && std::ranges::any_of(boundary->facets, [&](const ConvexFacet& f) {
             return f.n_B.dot(down_B) > 0 && IsAlong(f.n_B) && IsOverFace(*boundary, f);
           });
  }
  bool operator()(const HalfSpace&) const { return false; }

  /** Returns whether the centre of mass is above the inside of `face`. */
  static bool IsOverFace(const ConvexFacets& boundary, const ConvexFacet& face) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const auto corner = [&](std::size_t n) -> const Vector3d& {
        const int index = face.corners[n % face.corners.size()];
        return boundary.corners[static_cast<std::size_t>(index)];
      };
      const Vector3d edge = corner(i + 1) - corner(i);
      if (!(face.n_B.cross(edge).dot(-corner(i)) > 0)) return false;
    }
    return true;
  }
};

}  // namespace

bool LiesFlat(const RigidBody& body, const Eigen::Vector3d& n_W) {
  const Eigen::Vector3d down_B = body.placed.X_WB.R_WB.transpose() * -n_W;
  return std::visit(IsFlat{down_B}, body.placed.shape);
}

Arrival ArrivalAt(const Landing& landing, const Eigen::Vector3d& v_W,
                  const Eigen::Vector3d& a_W) {
  // The first root of gap + v t + ½ a t² = 0, written so that nothing cancels.
  const double gap = std::max(0.0, landing.gap);
  const double v = landing.n_W.dot(v_W);
  const double a = landing.n_W.dot(a_W);
  const double speed = std::sqrt(v * v - 2 * a * gap);
  if (v < 0) return {2 * gap / (speed - v), speed};
  if (a < 0) return {-(v + speed) / a, speed};
  return {std::numeric_limits<double>::quiet_NaN(), speed};
}

Eigen::Vector3d SupportOf(const RigidBody& body, const Eigen::Vector3d& d_W) {
  const Pose& pose = body.placed.X_WB;
  if (const auto* sphere = std::get_if<Sphere>(&body.placed.shape))
    return pose.p_WB + sphere->radius * d_W.normalized();
  return pose * std::visit(Farthest{pose.R_WB.transpose() * d_W}, body.placed.shape);
}

std::optional<Landing> LandingOf(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!body.collides) return std::nullopt;
  std::optional<Landing> nearest;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& ground = world.bodies[i];
    if (ground.mass > 0 || !ground.collides) continue;
    const std::optional<Plane> plane = PlaneUnder(ground.placed, body.placed.X_WB.p_WB);
    if (!plane || plane->n_W.dot(body.placed.X_WB.p_WB - plane->p_W) <= 0) continue;
    const Eigen::Vector3d p_WC = SupportOf(body, -plane->n_W);
    const double gap = plane->n_W.dot(p_WC - plane->p_W);
    if (nearest && nearest->gap <= gap) continue;
    nearest = Landing{static_cast<int>(i),
                      plane->n_W,
                      gap,
                      p_WC,
                      std::min(body.restitution, ground.restitution),
                      std::sqrt(body.friction * ground.friction)};
  }
  return nearest;
}

std::optional<Landing> LandingOfPoint(const World& world, const Eigen::Vector3d& p_W) {
  std::optional<Landing> nearest;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& ground = world.bodies[i];
    if (ground.mass > 0 || !ground.collides) continue;
    const std::optional<Plane> plane = PlaneUnder(ground.placed, p_W);
    if (!plane) continue;
    const double gap = plane->n_W.dot(p_W - plane->p_W);
    if (gap < 0 || (nearest && nearest->gap <= gap)) continue;
    nearest = Landing{static_cast<int>(i), plane->n_W, gap, p_W};
  }
  return nearest;
}

}  // namespace touchstone
