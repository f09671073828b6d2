#include "reports/referee/round_solid.h"

#include <limits>

namespace touchstone::referee {
namespace {

using Number = Bounded<Precise>;

/** A point in the half-plane of the axis: distance from the axis, and height. */
struct Meridian {
  Number radius, height;
};

/** Returns the signed distance from a convex polygon in the half-plane, given the largest
 of its signed distances from the lines of its sides, and its distance from the sides. */
Enclosure Signed(const Number& beyond, const Number& distance) {
  const Enclosure inside = beyond.enclosure();
  if (inside.hi <= 0) return inside;
  // Outside no side is farther than the polygon, and inside all distances are negative.
  return {inside.lo, distance.enclosure().hi};
}

Number Hypotenuse(const Number& a, const Number& b) {
  return Sqrt(a * a + b * b);
}

Enclosure DistanceFrom(const Cylinder& cylinder, const Meridian& p) {
  const Number side = p.radius - Number(cylinder.radius);
  const Number end = Abs(p.height) - Number(cylinder.half_length);
  const Number beyond = Max(side, end);
  const Number distance = Hypotenuse(Max(side, Number()), Max(end, Number()));
  const Enclosure inside = beyond.enclosure();
  return inside.lo > 0 ? distance.enclosure() : Signed(beyond, distance);
}

/** Returns the distance of p from the segment from a by e. */
Number FromSegment(const Meridian& p, const Meridian& a, const Meridian& e) {
  const Number radius = p.radius - a.radius;
  const Number height = p.height - a.height;
  const Number t = (radius * e.radius + height * e.height) /
                   (e.radius * e.radius + e.height * e.height);
  const Number on = Max(Number(), Min(t, Number(1.0)));
  return Hypotenuse(radius - on * e.radius, height - on * e.height);
}

Enclosure DistanceFrom(const Cone& cone, const Meridian& p) {
  const Number r(cone.radius);
  const Number h(cone.half_height);
  const Number height = h + h;
  // The side falls from the apex (0, h) to the rim (r, −h); (2 h, r) points out of it.
  const Number side = (height * p.radius + r * (p.height - h)) / Hypotenuse(height, r);
  const Number beyond = Max(side, -h - p.height);
  const Number distance = Min(FromSegment(p, {Number(), -h}, {r, Number()}),
                              FromSegment(p, {r, -h}, {-r, height}));
  const Enclosure inside = beyond.enclosure();
  return inside.lo > 0 ? distance.enclosure() : Signed(beyond, distance);
}

/** The point c in the frame in which the columns of R are the axes: R⁻¹ c by cofactors.
 */
Vector<Number> Solve(const Eigen::Matrix3d& R, const Vector<Number>& c) {
  const Vector<Number> x = Exactly<Number>(Eigen::Vector3d(R.col(0)));
  const Vector<Number> y = Exactly<Number>(Eigen::Vector3d(R.col(1)));
  const Vector<Number> z = Exactly<Number>(Eigen::Vector3d(R.col(2)));
  const Number volume = Dot(x, Cross(y, z));
  return {Dot(c, Cross(y, z)) / volume, Dot(c, Cross(z, x)) / volume,
          Dot(c, Cross(x, y)) / volume};
}

}  // namespace

std::optional<Enclosure> DistanceFromRoundSolid(const MinkowskiDifference& M) {
  const bool point_is_A = std::holds_alternative<Point>(M.A().core);
  const RoundedCore& solid = point_is_A ? M.B() : M.A();
  const RoundedCore& point = point_is_A ? M.A() : M.B();
  if (!std::holds_alternative<Point>(point.core) || !IsCurved(solid.core)) return {};
  // A matrix further from a rotation would widen the result by more than a few ulps.
  const double defect = OrthonormalityDefect(solid.X_WB.R_WB);
  if (defect > 8 * std::numeric_limits<double>::epsilon()) return {};

  const Vector<Number> c =
      Exactly<Number>(point.X_WB.p_WB) - Exactly<Number>(solid.X_WB.p_WB);
  const Vector<Number> q = Solve(solid.X_WB.R_WB, c);
  const Meridian p{Hypotenuse(q.x, q.y), q.z};
  const auto* cylinder = std::get_if<Cylinder>(&solid.core);
  const Enclosure distance = cylinder != nullptr
                                 ? DistanceFrom(*cylinder, p)
                                 : DistanceFrom(std::get<Cone>(solid.core), p);
  // The computed defect is itself rounded, by less than 8 roundoffs of its unit sums.
  const double stretch = 2 * (defect + 8 * kRoundoff<double>);
  const auto stretched = [&](double d) {
    return Number(d) * Number(Precise(0), stretch);
  };
  return Enclosure{(Number(distance.lo) + stretched(distance.lo)).enclosure().lo,
                   (Number(distance.hi) + stretched(distance.hi)).enclosure().hi};
}

}  // namespace touchstone::referee
