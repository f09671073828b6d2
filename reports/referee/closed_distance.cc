#include "reports/referee/closed_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "reports/referee/bounded.h"
#include "reports/referee/minkowski_difference.h"
#include "reports/referee/vector.h"

namespace touchstone::referee {
namespace {

using Real = DoubleDouble;
using Number = Bounded<Real>;
using V = Vector<Number>;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Number Positive(const Number& x) {
  return Max(x, Number());
}

Number Clamped(const Number& x, const Number& least, const Number& most) {
  return Max(least, Min(x, most));
}

Number Length(const Number& x, const Number& y) {
  return Sqrt(x * x + y * y);
}

/** Signed distances from shapes at the origin. Where a value is too near a case's limit
 to tell the case, the enclosure holds in both. [m] */
struct DistanceAt {
  const V& q;  ///< The point, in the body frame.

  Enclosure operator()(const Box& box) const {
    const Number x = Abs(q.x) - Number(box.half_extents.x());
    const Number y = Abs(q.y) - Number(box.half_extents.y());
    const Number z = Abs(q.z) - Number(box.half_extents.z());
    const Number outside = Norm(V{Positive(x), Positive(y), Positive(z)});
    return (outside + Min(Max(x, Max(y, z)), Number())).enclosure();
  }

  Enclosure operator()(const Cylinder& cylinder) const {
    const Number side = Length(q.x, q.y) - Number(cylinder.radius);
    const Number end = Abs(q.z) - Number(cylinder.half_length);
    const Number outside = Length(Positive(side), Positive(end));
    return (outside + Min(Max(side, end), Number())).enclosure();
  }

  /** In the half-plane of the axis and the point the cone is a triangle. Its side falls
   from the apex (0, h) by (r, −2h). */
  Enclosure operator()(const Cone& cone) const {
    const Number r(cone.radius);
    const Number h(cone.half_height);
    const Number fall = h + h;
    const Number square = r * r + fall * fall;
    const Number out = Length(q.x, q.y);
    const Number below = h - q.z;  // The height of the point below the apex.
    const Number beyond_side = (out * fall - below * r) / Sqrt(square);
    const Number beyond_base = below - fall;
    // The distance beyond any plane of a convex body is at most the signed distance, and
    // inside the largest is that distance.
    const Enclosure beyond = Max(beyond_side, beyond_base).enclosure();
    if (beyond.hi <= 0) return beyond;
    const Number t =
        Clamped((out * r + below * fall) / square, Number(), Number(Real(1)));
    const Number from_side = Length(out - t * r, below - t * fall);
    const Number from_base = Length(Positive(out - r), beyond_base);
    const Enclosure outside = Min(from_side, from_base).enclosure();
    return {beyond.lo > 0 ? outside.lo : beyond.lo, outside.hi};
  }

  // Not flat, see ClosedDistance().
  template <typename Other>
  Enclosure operator()(const Other&) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {-kInfinity, kInfinity};
  }
};

/** Returns the enclosure of the distance from the image under R of a flat shape, from the
 one in its body frame. The point is R q with |q − q̂| <= |e| / s for the residual e of q̂,
 and R stretches every length by a factor in [1 − d, 1 + d], see input_rounding.cc. The
 computed defect of R is off by two roundings of 1. */
Enclosure Stretched(const Eigen::Matrix3d& R, const Enclosure& of_guess, const V& e) {
  const double residual = Norm(e).enclosure().hi;
  const double d = 2 * (OrthonormalityDefect(R) + 2 * kEpsilon);
  constexpr double kRounded = 1 + 8 * kEpsilon;
  const auto widened = [&](double bound) {
    return (std::abs(bound) * d + 2 * residual * (1 + d)) * kRounded;
  };
  return {Below(of_guess.lo, widened(of_guess.lo)),
          -Below(-of_guess.hi, widened(of_guess.hi))};
}

/** Returns the distance from a box, a cylinder or a cone. `y` is from the body origin. */
Enclosure FromFlat(const Body& body, const V& y) {
  const Eigen::Matrix3d& R = body.X_WB.R_WB;
  const Vector<Real> to = {y.x.value(), y.y.value(), y.z.value()};
  // Rᵀ inverts R up to some roundings, and a second step inverts it to their square.
  const Vector<Real> first = RotateBack(R, to);
  const V q = Exactly<Number>(first + RotateBack(R, to - Rotate(R, first)));
  return Stretched(R, std::visit(DistanceAt{q}, body.shape), y - Rotate(R, q));
}

/** Returns the distance from the ball of `radius` that is swept along the axis to ±h. The
 axis is turned by R, the ball is not. */
Enclosure FromRound(const Body& body, const V& y, double h, double radius) {
  const V axis = Exactly<Number>(Eigen::Vector3d(body.X_WB.R_WB.col(2)));
  const Number t = Clamped(Dot(axis, y) / Dot(axis, axis), Number(-h), Number(h));
  return (Norm(y - t * axis) - Number(radius)).enclosure();
}

/** Returns the distance from the plane through the images of the body's x and y axes. */
Enclosure FromPlane(const Body& body, const V& y) {
  const Eigen::Matrix3d& R = body.X_WB.R_WB;
  const V n = Cross(Exactly<Number>(Eigen::Vector3d(R.col(0))),
                    Exactly<Number>(Eigen::Vector3d(R.col(1))));
  return (Dot(n, y) / Norm(n)).enclosure();
}

Enclosure DistanceFrom(const Body& body, const V& y) {
  if (std::holds_alternative<HalfSpace>(body.shape)) return FromPlane(body, y);
  if (const auto* sphere = std::get_if<Sphere>(&body.shape))
    return (Norm(y) - Number(sphere->radius)).enclosure();
  if (const auto* capsule = std::get_if<Capsule>(&body.shape))
    return FromRound(body, y, capsule->half_length, capsule->radius);
  return FromFlat(body, y);
}

}  // namespace

std::optional<Enclosure> ClosedDistance(const Body& body, const Eigen::Vector3d& p_W) {
  const ShapeKind kind = KindOf(body.shape);
  if (kind == ShapeKind::kConvexHull) return std::nullopt;
  const V y = Exactly<Number>(p_W) - Exactly<Number>(body.X_WB.p_WB);
  const Enclosure distance = DistanceFrom(body, y);
  const double size = (p_W - body.X_WB.p_WB).norm() + BoundingRadius(body.shape);
  const double most = kEpsilon * std::max(size, 32 * std::min(std::abs(distance.lo),
                                                              std::abs(distance.hi)));
  const double width = distance.hi - distance.lo;
  if (!std::isfinite(width) || width > most) return std::nullopt;
  return distance;
}

}  // namespace touchstone::referee
