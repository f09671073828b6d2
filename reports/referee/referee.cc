#include "reports/referee/referee.h"

#include <array>
#include <limits>

#include "reports/referee/closed_distance.h"
#include "reports/referee/core_truth.h"
#include "reports/referee/digits.h"
#include "reports/referee/direction.h"
#include "reports/referee/half_space.h"
#include "reports/referee/input_rounding.h"
#include "reports/referee/nearest_point.h"
#include "reports/referee/overlap_in.h"
#include "reports/referee/proved.h"
#include "reports/referee/unit_scale.h"
#include "reports/referee/witnesses.h"

namespace touchstone {
namespace {

using namespace referee;

Touching Decide(const Enclosure& separation, double input_rounding) {
  if (separation.lo > input_rounding) return Touching::kApart;
  if (separation.hi < -input_rounding) return Touching::kTouching;
  return Touching::kUndecided;
}

std::string MethodOf(const MinkowskiDifference& M) {
  if (M.IsCurved()) return "bounds";
  return M.A().radius > 0 || M.B().radius > 0 ? "core" : "polytope";
}

/** Returns the overlap with a plane, with as few digits as make it tight. */
PlaneOverlap TightOverlapWithPlane(const ContactQuery& query) {
  const PlaneOverlap plane = OverlapWithPlane<DoubleDouble>(query);
  return IsTight(plane.overlap) ? plane : OverlapWithPlane<Precise>(query);
}

ContactTruth JudgeAgainstPlane(const ContactQuery& query) {
  const PlaneOverlap plane = TightOverlapWithPlane(query);
  const bool plane_is_A = KindOf(query.A.shape) == ShapeKind::kHalfSpace;
  ContactTruth truth;
  truth.separation = {-plane.overlap.hi, -plane.overlap.lo};
  truth.certificate = {plane.n_AB_W, plane_is_A ? plane.p_WPlane : plane.p_WX,
                       plane_is_A ? plane.p_WX : plane.p_WPlane};
  truth.method = "half_space";
  return truth;
}

/** Returns the point of a body, given as the combination of `q` in its body frame, moved
 by `radius` along n_W. Each coordinate is rounded once. [m] */
template <typename Real>
Eigen::Vector3d PointOf(const RoundedCore& core, const Witnesses<Real>& points,
                        const std::array<Vector<Real>, 4>& q,
                        const Eigen::Vector3d& n_W) {
  Real total(0);
  Vector<Real> sum{Real(0), Real(0), Real(0)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i) {
    total = total + points.weights[i];
    sum = sum + points.weights[i] * q[i];
  }
  return Rounded(Exactly<Real>(core.X_WB.p_WB) +
                 Rotate(core.X_WB.R_WB, (Real(1) / total) * sum) +
                 Real(core.radius) * Exactly<Real>(n_W));
}

/** The truth of two bounded bodies in their own unit, as proved in `Real`. */
template <typename Real>
struct BoundedTruth {
  CoreTruth<Real> core;
  Enclosure separation;

  explicit BoundedTruth(const ContactQuery& scaled, const MinkowskiDifference& M)
      : core(JudgeCores<Real>(M)), separation(Proved(scaled, core)) {}

  bool IsFinal(const MinkowskiDifference& M) const {
    return referee::IsFinal(core.separation, separation, M);
  }

  ContactTruth InMetres(const MinkowskiDifference& M, int unit) const {
    const Eigen::Vector3d& n = core.n_AB_W;
    ContactTruth truth;
    truth.separation = referee::InMetres(separation, unit);
    truth.certificate = {
        n, referee::InMetres(PointOf(M.A(), core.points, core.points.q_A, n), unit),
        referee::InMetres(PointOf(M.B(), core.points, core.points.q_B, -n), unit)};
    truth.method = MethodOf(M);
    return truth;
  }
};

ContactTruth JudgeBounded(const ContactQuery& query) {
  const auto [scaled, unit] = InOwnUnit(query);
  const MinkowskiDifference M(scaled.A, scaled.B);
  const BoundedTruth<DoubleDouble> truth(scaled, M);
  if (truth.IsFinal(M)) return truth.InMetres(M, unit);
  return BoundedTruth<Precise>(scaled, M).InMetres(M, unit);
}

/** Returns the overlap along a direction n other than the plane's normal m. B moved by t
 > 0 along n just leaves the half-space where t (n·m) is the overlap along m. A gap is
 multiplied by n·m instead of divided, so that both cases bound −separation. */
Enclosure TiltedOverlap(const PlaneOverlap& plane, const Eigen::Vector3d& n_W) {
  // The referee's own rounding of the normal stands for the normal.
  if (n_W == plane.n_AB_W) return plane.overlap;
  using Near = Bounded<double>;
  // The normal is accurate to a few roundings of a unit vector.
  constexpr double kNormalError = 8 * std::numeric_limits<double>::epsilon();
  const Vector<Near> n = Exactly<Near>(n_W);
  const Vector<Near> m = {Near(plane.n_AB_W.x(), kNormalError),
                          Near(plane.n_AB_W.y(), kNormalError),
                          Near(plane.n_AB_W.z(), kNormalError)};
  const Near cosine = Dot(n, m) / Norm(n);
  if (cosine.enclosure().lo <= 0) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {kInfinity, kInfinity};
  }
  const auto along = [&](double overlap) {
    return (overlap > 0 ? Near(overlap) / cosine : Near(overlap) * cosine).enclosure();
  };
  return {along(plane.overlap.lo).lo, along(plane.overlap.hi).hi};
}

}  // namespace

ContactTruth ComputeContactTruth(const ContactQuery& query) {
  ContactTruth truth =
      HasHalfSpace(query) ? JudgeAgainstPlane(query) : JudgeBounded(query);
  truth.input_rounding = InputRounding(query);
  truth.touching = Decide(truth.separation, truth.input_rounding);
  return truth;
}

bool AreProvedApart(const ContactQuery& query) {
  if (HasHalfSpace(query)) return false;
  const MinkowskiDifference M(query.A, query.B);
  const Simplex<double> nearest = FindNearest<double>(M, {});
  const Eigen::Vector3d n = -Direction(nearest.v);
  return !nearest.encloses_origin && !n.isZero(0) && OverlapIn<double>(query, n).hi < 0;
}

Enclosure Overlap(const ContactQuery& query, const Eigen::Vector3d& n_W) {
  if (HasHalfSpace(query)) return TiltedOverlap(TightOverlapWithPlane(query), n_W);
  const Enclosure overlap = OverlapIn<DoubleDouble>(query, n_W);
  return IsTight(overlap) ? overlap : OverlapIn<Precise>(query, n_W);
}

Enclosure SignedDistance(const Body& body, const Eigen::Vector3d& p_W) {
  if (const auto distance = ClosedDistance(body, p_W)) return *distance;
  // A ball of radius zero: the separation from it is the distance of its centre.
  const Body point{Sphere{0}, Pose::FromMatrix(p_W, Eigen::Matrix3d::Identity())};
  const ContactQuery query{body, point};
  if (HasHalfSpace(query)) return JudgeAgainstPlane(query).separation;
  const auto [scaled, unit] = InOwnUnit(query);
  const MinkowskiDifference M(scaled.A, scaled.B);
  const BoundedTruth<DoubleDouble> truth(scaled, M);
  const Enclosure& distance = truth.separation;
  // The direction of a certificate is rounded to doubles. Near a surface that leaves some
  // 2^-53 of the scene unproved, whatever the digits of the search.
  const double left = std::numeric_limits<double>::epsilon() * M.Size();
  if (distance.hi - distance.lo <= left || truth.IsFinal(M))
    return InMetres(distance, unit);
  return InMetres(BoundedTruth<Precise>(scaled, M).separation, unit);
}

}  // namespace touchstone
