#include "oracles/ode/ode_contact_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace touchstone {
namespace {

using Eigen::Vector3d;

double BoxHeight(const Vector3d& half_extents, const Vector3d& p_B) {
  return (p_B.cwiseAbs() - half_extents).maxCoeff();
}

// How far a point is from the surface of the three shapes with which ODE's choice varies.
struct DistanceToSurface {
  Vector3d p_B;

  double operator()(const Box& s) const {
    return std::abs(BoxHeight(s.half_extents, p_B));
  }
  double operator()(const Capsule& s) const {
    const double along = std::clamp(p_B.z(), -s.half_length, s.half_length);
    const double round = std::abs((p_B - along * Vector3d::UnitZ()).norm() - s.radius);
    // A deep capsule is a box to dCollideCapsuleBox.
    const Vector3d half_extents(s.radius, s.radius, s.radius + s.half_length);
    return std::min(round, std::abs(BoxHeight(half_extents, p_B)));
  }
  double operator()(const Cylinder& s) const {
    const double beside = std::hypot(p_B.x(), p_B.y()) - s.radius;
    return std::abs(std::max(beside, std::abs(p_B.z()) - s.half_length));
  }
  double operator()(const Sphere&) const { return 0; }
  double operator()(const Cone&) const { return 0; }
  double operator()(const ConvexHull&) const { return 0; }
  double operator()(const HalfSpace&) const { return 0; }
};

double Distance(const Body& body, const Vector3d& p_W) {
  const Vector3d p_B = body.X_WB.R_WB.transpose() * (p_W - body.X_WB.p_WB);
  return std::visit(DistanceToSurface{p_B}, body.shape);
}

// The one of {on A, midway, on B} that `contact` is, as the shift along n to midway.
double ShiftByFit(const ContactQuery& query, const OdeContact& contact) {
  const double half = contact.depth / 2;
  // A's surface is half the depth further along n than the midway point, B's half before.
  const std::array<double, 3> shifts = {0, -half, half};
  const auto misfit = [&](double shift) {
    const Vector3d midway = contact.p_W + shift * contact.n_AB_W;
    return Distance(query.A, midway + half * contact.n_AB_W) +
           Distance(query.B, midway - half * contact.n_AB_W);
  };
  return *std::ranges::min_element(shifts, {}, misfit);
}

// Whether dCollideCylinderCylinder() took the branch that lays discs on each other; all
// else of it is MPR. Its own test of the axes is 1 − |cos| < 1e-3, its normal then one of
// them.
bool IsDiscOnDisc(const ContactQuery& query, const Vector3d& n_W) {
  const Vector3d axis_A = query.A.X_WB.R_WB.col(2);
  const Vector3d axis_B = query.B.X_WB.R_WB.col(2);
  // Above the rounding of an axis through ODE's quaternions, below any other normal.
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
  if (const auto* sphere = std::get_if<Sphere>(&query.A.shape)) {
    return p + (sphere->radius - half - n.dot(p - query.A.X_WB.p_WB)) * n;
  }
  if (const auto* sphere = std::get_if<Sphere>(&query.B.shape)) {
    return p - (sphere->radius - half + n.dot(p - query.B.X_WB.p_WB)) * n;
  }
  const bool cylinders =
      is(query.A, ShapeKind::kCylinder) && is(query.B, ShapeKind::kCylinder);
  if (either(ShapeKind::kBox) || (cylinders && IsDiscOnDisc(query, n))) {
    return p + ShiftByFit(query, contact) * n;
  }
  return p;
}

}  // namespace touchstone
