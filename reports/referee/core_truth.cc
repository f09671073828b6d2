#include "reports/referee/core_truth.h"

#include <algorithm>
#include <limits>

#include "reports/referee/nearest_point.h"
#include "reports/referee/zonotope.h"

namespace touchstone::referee {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUlp = std::numeric_limits<double>::epsilon();

Enclosure Intersection(const Enclosure& a, const Enclosure& b) {
  return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
}

double Width(const Enclosure& e) {
  return e.hi - e.lo;
}

Enclosure Negated(const Enclosure& e) {
  return {-e.hi, -e.lo};
}

/** Returns the overlap of the cores along the unit vector that `n` normalises to. */
Enclosure OverlapAlong(const MinkowskiDifference& M, const Eigen::Vector3d& n) {
  using Number = Bounded<Precise>;
  const Vector<Number> exact = Exactly<Number>(n);
  return (M.SupportValue(exact) / Norm(exact)).enclosure();
}

/** Returns a unit vector perpendicular to a line along `direction`; any where it has
 * none. */
Eigen::Vector3d Perpendicular(const Eigen::Vector3d& direction) {
  Eigen::Index least;
  direction.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d n = direction.cross(Eigen::Vector3d::Unit(least));
  return n.isZero(0) ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : n.stableNormalized();
}

void SetSupportingPoints(const MinkowskiDifference& M, CoreTruth* truth) {
  const DifferencePoint<double> deepest = M.Support(Exactly<double>(truth->n_AB_W));
  truth->p_WCa = M.A().X_WB * ToEigen(deepest.q_A);
  truth->p_WCb = M.B().X_WB * ToEigen(deepest.q_B);
}

/** Returns the truth that `simplex` proves, searching on at high precision where its
 features turn out not to be the nearest. */
CoreTruth Refine(const MinkowskiDifference& M, const Simplex<double>& simplex) {
  Simplex<Precise> sharp = Sharpen(M, simplex);
  CoreTruth truth;
  truth.separation = CertifyNearest(M, sharp);
  // Right features leave nothing but the rounding of the result. Of points on a round rim
  // the simplex of doubles knows only that many digits, however right it is.
  const double rounding =
      M.IsCurved() ? 8 * kUlp * M.Size() : 4 * kUlp * std::abs(truth.separation.hi);
  if (!(Width(truth.separation) <= rounding)) {
    sharp = FindNearest(M, sharp);
    truth.separation = Intersection(truth.separation, CertifyNearest(M, sharp));
  }
  Eigen::Vector3d q_A = Eigen::Vector3d::Zero();
  Eigen::Vector3d q_B = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(sharp.count); ++i) {
    const double weight = Nearest(sharp.weights[i] / sharp.weights[0]);
    const DifferencePoint<Precise>& point = sharp.points[i];
    q_A += weight * Eigen::Vector3d(Nearest(point.q_A.x), Nearest(point.q_A.y),
                                    Nearest(point.q_A.z));
    q_B += weight * Eigen::Vector3d(Nearest(point.q_B.x), Nearest(point.q_B.y),
                                    Nearest(point.q_B.z));
    total += weight;
  }
  truth.p_WCa = M.A().X_WB * Eigen::Vector3d(q_A / total);
  truth.p_WCb = M.B().X_WB * Eigen::Vector3d(q_B / total);
  truth.n_AB_W =
      -Eigen::Vector3d(Nearest(sharp.v.x), Nearest(sharp.v.y), Nearest(sharp.v.z))
           .stableNormalized();
  return truth;
}

/** Offers the overlap along `n` as a lower bound on the separation. */
void Improve(const Eigen::Vector3d& n, const Enclosure& overlap, CoreTruth* truth) {
  if (-overlap.hi < truth->separation.lo) return;
  truth->separation.lo = -overlap.hi;
  truth->n_AB_W = n;
}

CoreTruth JudgeZonotopes(const MinkowskiDifference& M) {
  const std::optional<CoreDepth> depth = ZonotopeDepth(M);
  if (depth && depth->depth.lo > 0) {
    CoreTruth truth;
    truth.separation = Negated(depth->depth);
    truth.n_AB_W = depth->n_AB_W;
    SetSupportingPoints(M, &truth);
    return truth;
  }
  CoreTruth truth = Refine(M, FindNearest<double>(M, {}));
  if (truth.separation.lo > 0) return truth;
  // The origin is on M to rounding, where the mixture has no direction of its own.
  if (depth) {
    Improve(depth->n_AB_W, depth->depth, &truth);
  } else {
    const bool segment_A = std::holds_alternative<Segment>(M.A().core);
    const Eigen::Vector3d n = Perpendicular((segment_A ? M.A() : M.B()).X_WB.R_WB.col(2));
    Improve(n, OverlapAlong(M, n), &truth);
  }
  return truth;
}

}  // namespace

CoreTruth JudgeCores(const MinkowskiDifference& M) {
  if (IsZonotope(M.A().core) && IsZonotope(M.B().core)) return JudgeZonotopes(M);
  const Simplex<double> simplex = FindNearest<double>(M, {});
  const CoreTruth truth = Refine(M, simplex);
  return truth;
}

}  // namespace touchstone::referee
