#include "reports/referee/referee.h"

#include <array>
#include <limits>

#include "reports/referee/core_truth.h"
#include "reports/referee/direction.h"
#include "reports/referee/half_space.h"
#include "reports/referee/input_rounding.h"
#include "reports/referee/proved.h"
#include "reports/referee/support.h"
#include "reports/referee/unit_scale.h"
#include "reports/referee/witnesses.h"

namespace touchstone {
namespace {

using namespace referee;

using Number = Bounded<Precise>;

Touching Decide(const Enclosure& separation, double input_rounding) {
  if (separation.lo > input_rounding) return Touching::kApart;
  if (separation.hi < -input_rounding) return Touching::kTouching;
  return Touching::kUndecided;
}

std::string MethodOf(const MinkowskiDifference& M) {
  if (M.IsCurved()) return "bounds";
  return M.A().radius > 0 || M.B().radius > 0 ? "core" : "polytope";
}

ContactTruth JudgeAgainstPlane(const ContactQuery& query) {
  const PlaneOverlap plane = OverlapWithPlane(query);
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
Eigen::Vector3d PointOf(const RoundedCore& core, const Witnesses& points,
                        const std::array<Vector<Precise>, 4>& q,
                        const Eigen::Vector3d& n_W) {
  Precise total(0);
  Vector<Precise> sum{Precise(0), Precise(0), Precise(0)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i) {
    total = total + points.weights[i];
    sum = sum + points.weights[i] * q[i];
  }
  return Rounded(Exactly<Precise>(core.X_WB.p_WB) +
                 Rotate(core.X_WB.R_WB, (Precise(1) / total) * sum) +
                 Precise(core.radius) * Exactly<Precise>(n_W));
}

ContactTruth JudgeBounded(const ContactQuery& query) {
  const auto [scaled, unit] = InOwnUnit(query);
  const MinkowskiDifference M(scaled.A, scaled.B);
  const CoreTruth core = JudgeCores(M);
  const Eigen::Vector3d& n = core.n_AB_W;
  ContactTruth truth;
  truth.separation = InMetres(Proved(scaled, core), unit);
  truth.certificate = {n, InMetres(PointOf(M.A(), core.points, core.points.q_A, n), unit),
                       InMetres(PointOf(M.B(), core.points, core.points.q_B, -n), unit)};
  truth.method = MethodOf(M);
  return truth;
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

Enclosure Overlap(const ContactQuery& query, const Eigen::Vector3d& n_W) {
  if (HasHalfSpace(query)) return TiltedOverlap(OverlapWithPlane(query), n_W);
  return ((SupportOf(query.A, n_W) + SupportOf(query.B, -n_W)) /
          Norm(Exactly<Number>(n_W)))
      .enclosure();
}

Enclosure SignedDistance(const Body& body, const Eigen::Vector3d& p_W) {
  // A ball of radius zero: the separation from it is the distance of its centre.
  const Body point{Sphere{0}, Pose::FromMatrix(p_W, Eigen::Matrix3d::Identity())};
  const ContactQuery query{body, point};
  if (HasHalfSpace(query)) return JudgeAgainstPlane(query).separation;
  // A number needs no certificate: its points take a tenth of the time.
  const auto [scaled, unit] = InOwnUnit(query);
  return InMetres(Proved(scaled, JudgeCores(MinkowskiDifference(scaled.A, scaled.B))),
                  unit);
}

}  // namespace touchstone
