#include "oracles/ode/ode_contact_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <variant>

namespace touchstone {
namespace {

using Eigen::Vector3d;

double BoxHeight(const Vector3d& half_extents, const Vector3d& p_B) {
  return (p_B.cwiseAbs() - half_extents).maxCoeff();
}

// The distance of a point from the surface of a shape; 0 for the three shapes for which
// the place of ODE's point does not vary. [m]
struct DistanceToSurface {
  Vector3d p_B;

  double operator()(const Box& s) const {
    return std::abs(BoxHeight(s.half_extents, p_B));
  }
  double operator()(const Capsule& s) const {
    const double along = std::clamp(p_B.z(), -s.half_length, s.half_length);
    const double round = std::abs((p_B - along * Vector3d::UnitZ()).norm() - s.radius);
    // dCollideCapsuleBox treats a deep capsule as a box.
    const Vector3d half_extents(s.radius, s.radius, s.radius + s.half_length);
    return std::min(round, std::abs(BoxHeight(half_extents, p_B)));
  }
  double operator()(const Cylinder& s) const {
    const double beside = std::hypot(p_B.x(), p_B.y()) - s.radius;
    return std::abs(std::max(beside, std::abs(p_B.z()) - s.half_length));
  }
  double operator()(const Sphere& s) const { return std::abs(p_B.norm() - s.radius); }
  double operator()(const Cone&) const { return 0; }
  double operator()(const ConvexHull&) const { return 0; }
  double operator()(const HalfSpace&) const { return 0; }
};

Vector3d InBodyFrame(const Body& body, const Vector3d& p_W) {
  return body.X_WB.R_WB.transpose() * (p_W - body.X_WB.p_WB);
}

double Distance(const Body& body, const Vector3d& p_W) {
  return std::visit(DistanceToSurface{InBodyFrame(body, p_W)}, body.shape);
}

// The best of `shifts` along n: with it, the midway point fits both surfaces best. [m]
double BestOf(std::span<const double> shifts, const ContactQuery& query,
              const OdeContact& contact) {
  const double half = contact.depth / 2;
  const auto misfit = [&](double shift) {
    const Vector3d midway = contact.p_W + shift * contact.n_AB_W;
    return Distance(query.A, midway + half * contact.n_AB_W) +
           Distance(query.B, midway - half * contact.n_AB_W);
  };
  return *std::ranges::min_element(shifts, {}, misfit);
}

// The shift to midway for a sphere A and a box: from the sphere's centre if that is
// inside the box, otherwise from the surface of the box. [m]
double ShiftOfSphereAtBox(const Sphere& sphere, const Vector3d& centre_W, const Body& box,
                          double half) {
  const double height =
      BoxHeight(std::get<Box>(box.shape).half_extents, InBodyFrame(box, centre_W));
  return height > 0 ? half : sphere.radius - half;
}

// Whether dCollideCylinderCylinder() used its special case for two discs on each other;
// it uses MPR otherwise. Its own condition for the axes is 1 − |cos| < 1e-3, and its
// normal is then one of the axes.
bool IsDiscOnDisc(const ContactQuery& query, const Vector3d& n_W) {
  const Vector3d axis_A = query.A.X_WB.R_WB.col(2);
  const Vector3d axis_B = query.B.X_WB.R_WB.col(2);
  // Larger than the rounding of an axis by ODE's quaternions, smaller than the deviation
  // of any other normal.
  constexpr double kAlong = 1e-12;
  return 1 - std::abs(axis_A.dot(axis_B)) < 1e-3 &&
         1 - std::max(std::abs(axis_A.dot(n_W)), std::abs(axis_B.dot(n_W))) < kAlong;
}

}  // namespace

Eigen::Vector3d MidwayPoint(const ContactQuery& query, const OdeContact& contact) {
  const auto is = [](const Body& body, ShapeKind kind) {
    return KindOf(body.shape) == kind;
  };
  const auto either = [&](ShapeKind kind) {
    return is(query.A, kind) || is(query.B, kind);
  };
  const Vector3d& p = contact.p_W;
  const Vector3d& n = contact.n_AB_W;
  const double half = contact.depth / 2;

  if (is(query.B, ShapeKind::kHalfSpace)) return p - half * n;
  if (is(query.A, ShapeKind::kHalfSpace)) return p + half * n;
  if (either(ShapeKind::kConvexHull)) return p;
  // A's surface is half the depth further along n than the midway point, B's surface half
  // the depth before it.
  const double from_A = -half;
  const double from_B = half;
  if (either(ShapeKind::kSphere)) {
    const bool first = is(query.A, ShapeKind::kSphere);
    const Body& ball = first ? query.A : query.B;
    const Body& other = first ? query.B : query.A;
    if (is(other, ShapeKind::kBox)) {
      const double shift =
          ShiftOfSphereAtBox(std::get<Sphere>(ball.shape), ball.X_WB.p_WB, other, half);
      return p + (first ? shift : -shift) * n;
    }
    if (const auto* cylinder = std::get_if<Cylinder>(&other.shape)) {
      // The axis is a radius below the cylinder's surface.
      const double from_axis = half - cylinder->radius;
      return p + BestOf(std::array{from_A, from_B, first ? from_axis : -from_axis}, query,
                        contact) *
                     n;
    }
    return p;
  }
  const bool cylinders =
      is(query.A, ShapeKind::kCylinder) && is(query.B, ShapeKind::kCylinder);
  if (either(ShapeKind::kBox) || (cylinders && IsDiscOnDisc(query, n))) {
    return p + BestOf(std::array{0.0, from_A, from_B}, query, contact) * n;
  }
  return p;
}

}  // namespace touchstone
