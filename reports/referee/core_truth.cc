#include "reports/referee/core_truth.h"

#include <algorithm>
#include <limits>

#include "reports/referee/coaxial_depth.h"
#include "reports/referee/direction.h"
#include "reports/referee/inner_polytope.h"
#include "reports/referee/nearest_point.h"
#include "reports/referee/portal.h"
#include "reports/referee/zonotope.h"

namespace touchstone::referee {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

double Width(const Enclosure& e) {
  return e.hi - e.lo;
}

Enclosure Negated(const Enclosure& e) {
  return {-e.hi, -e.lo};
}

/** Returns a unit vector perpendicular to `direction`, or any unit vector if `direction`
 is zero. */
Eigen::Vector3d Perpendicular(const Eigen::Vector3d& direction) {
  Eigen::Index least;
  direction.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d n = direction.cross(Eigen::Vector3d::Unit(least));
  return n.isZero(0) ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : n.stableNormalized();
}

template <typename Real>
void SetSupportingPoints(const MinkowskiDifference& M, CoreTruth<Real>* truth) {
  const DifferencePoint<double> deepest = M.Support(Exactly<double>(truth->n_AB_W));
  truth->points.count = 1;
  truth->points.weights[0] = 1;
  truth->points.q_A[0] = Exactly<Real>(deepest.q_A);
  truth->points.q_B[0] = Exactly<Real>(deepest.q_B);
  truth->is_deep = true;
}

/** Returns what `simplex` proves: the overlap along −v from below, and the length of v,
 whose points are its combinations of points of A and of B, from above. */
template <typename Real>
CoreTruth<Real> ProvedBy(const MinkowskiDifference& M, const Simplex<Real>& simplex) {
  CoreTruth<Real> truth;
  truth.separation = CertifyNearest(M, simplex);
  truth.n_AB_W = -Direction(simplex.v);
  truth.points.count = simplex.count;
  truth.points.weights = simplex.weights;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    truth.points.q_A[i] = simplex.points[i].q_A;
    truth.points.q_B[i] = simplex.points[i].q_B;
  }
  return truth;
}

/** Raises the lower bound on the separation to `lo`, which the overlap along `n` proves,
 if it is higher. */
template <typename Real>
void ImproveLower(double lo, const Eigen::Vector3d& n, CoreTruth<Real>* truth) {
  if (lo < truth->separation.lo) return;
  truth->separation.lo = lo;
  truth->n_AB_W = n;
}

/** Returns the best of both: each bound with the direction or the points that prove it.
 */
template <typename Real>
CoreTruth<Real> Best(const CoreTruth<Real>& a, const CoreTruth<Real>& b) {
  CoreTruth<Real> best = a.separation.hi < b.separation.hi ? a : b;
  ImproveLower(a.separation.lo, a.n_AB_W, &best);
  ImproveLower(b.separation.lo, b.n_AB_W, &best);
  return best;
}

/** The end of the search for the point of M nearest to the origin, and the truth that it
 proves. */
template <typename Real>
struct NearestTruth {
  Simplex<Real> simplex;
  CoreTruth<Real> truth;
};

/** Returns the truth that `simplex` proves. If its features are not the nearest, the
 search continues at high precision. */
template <typename Real>
NearestTruth<Real> Refine(const MinkowskiDifference& M, const Simplex<double>& simplex) {
  const Simplex<Real> sharp = Sharpen<Real>(M, simplex);
  const CoreTruth<Real> truth = ProvedBy(M, sharp);
  // With the right features only the rounding of the result is left, or near touching
  // that of `Real`, for some sixty operations. On a round rim the points of a double
  // simplex have no more digits than a double, even if the features are right.
  const double rounding = M.IsCurved()
                              ? 8 * kUlp * M.Size()
                              : std::max(4 * kUlp * std::abs(truth.separation.hi),
                                         64 * kRoundoff<Real> * M.Size());
  if (Width(truth.separation) <= rounding) return {sharp, truth};
  const Simplex<Real> sharper = FindNearest(M, sharp);
  return {sharper, Best(truth, ProvedBy(M, sharper))};
}

template <typename Real>
CoreTruth<Real> JudgeZonotopes(const MinkowskiDifference& M) {
  const ZonotopeFaces faces(M);
  // A face in double proves most pairs apart. Their depth is not needed.
  std::optional<CoreDepth> depth;
  if (!faces.ProveOutside()) depth = faces.LeastOverlap<Real>();
  const bool has_box =
      std::holds_alternative<Box>(M.A().core) || std::holds_alternative<Box>(M.B().core);
  // With a box the candidates are the normals of all faces of M: if the least overlap is
  // at least 0, the origin is in M. Without one M is flat, and its only candidate proves
  // no more than that the origin is in its plane.
  if (has_box && depth && depth->depth.lo >= 0) {
    CoreTruth<Real> truth;
    truth.separation = Negated(depth->depth);
    truth.n_AB_W = depth->n_AB_W;
    SetSupportingPoints(M, &truth);
    return truth;
  }
  CoreTruth<Real> truth = Refine<Real>(M, FindNearest<double>(M, {})).truth;
  if (truth.separation.lo > 0) return truth;
  // The origin is on the boundary of M to rounding, so the mixture v has no direction of
  // its own.
  if (!depth) depth = faces.LeastOverlap<Real>();
  if (depth) {
    ImproveLower(-depth->depth.hi, depth->n_AB_W, &truth);
  } else {
    const bool segment_A = std::holds_alternative<Segment>(M.A().core);
    const Eigen::Vector3d n = Perpendicular((segment_A ? M.A() : M.B()).X_WB.R_WB.col(2));
    const Enclosure overlap = M.OverlapAlong(Exactly<Bounded<Real>>(n)).enclosure();
    ImproveLower(-overlap.hi, n, &truth);
  }
  return truth;
}

template <typename Real>
CoreTruth<Real> FromDepth(const MinkowskiDifference& M, const DepthProof& proof) {
  CoreTruth<Real> truth;
  truth.separation = Negated(proof.depth);
  truth.n_AB_W = proof.n_AB_W;
  SetSupportingPoints(M, &truth);
  return truth;
}

/** Returns the intersection of both proofs. */
DepthProof Both(const DepthProof& a, const DepthProof& b) {
  return {{std::max(a.depth.lo, b.depth.lo), std::min(a.depth.hi, b.depth.hi)},
          a.depth.hi < b.depth.hi ? a.n_AB_W : b.n_AB_W};
}

/** Returns the truth if the origin is in M, or on its boundary to rounding. */
template <typename Real>
CoreTruth<Real> JudgeDeep(const MinkowskiDifference& M, const Simplex<double>& simplex) {
  // The target is the rounding of plane distances in double, which are sums of some ten
  // terms as large as M. Flat faces are met exactly. Round ones take a few facets per
  // digit, unless the least overlap is reached all around an axis of symmetry, which
  // cannot be tiled.
  const double target = 8 * kUlp * M.Size();
  const std::optional<DepthProof> coaxial = CoaxialDepth<Real>(M);
  if (coaxial && Width(coaxial->depth) <= 2 * target) return FromDepth<Real>(M, *coaxial);
  constexpr std::size_t kMostVertices = 1000;
  const InnerPolytope<double> polytope = Expand(M, simplex, target, kMostVertices);
  DepthProof proof = CertifyDepth<Real>(M, polytope, target);
  if (coaxial) proof = Both(proof, *coaxial);
  if (proof.depth.lo > 0 && Width(proof.depth) <= 2 * target)
    return FromDepth<Real>(M, proof);

  const NearestTruth<Real> nearest = Refine<Real>(M, simplex);
  CoreTruth<Real> truth = nearest.truth;
  if (truth.separation.lo > 0) return truth;
  if (!(proof.depth.lo > 0)) {
    ImproveLower(-proof.depth.hi, proof.n_AB_W, &truth);
    if (Width(truth.separation) <= target) return truth;
  }
  // Doubles are too coarse: the origin is too near the boundary, or the facets are too
  // thin.
  constexpr std::size_t kMostPreciseVertices = 200;
  const InnerPolytope<Real> sharp =
      Expand(M, nearest.simplex, target / 4, kMostPreciseVertices);
  proof = Both(proof, CertifyDepth<Real>(M, sharp, target));
  if (proof.depth.lo > 0) return FromDepth<Real>(M, proof);
  ImproveLower(-proof.depth.hi, proof.n_AB_W, &truth);
  return truth;
}

template <typename Real>
CoreTruth<Real> JudgeAny(const MinkowskiDifference& M) {
  const Simplex<double> simplex = FindNearest<double>(M, {});
  if (!simplex.encloses_origin) {
    const CoreTruth<Real> truth = Refine<Real>(M, simplex).truth;
    if (truth.separation.lo > 0) return truth;
  }
  return JudgeDeep<Real>(M, simplex);
}

/** Returns `truth`, improved near touching by a portal: the direction of its plane, and
 the nearest points that GJK finds from its corners. */
template <typename Real>
CoreTruth<Real> ImprovedByPortal(const MinkowskiDifference& M,
                                 const CoreTruth<Real>& truth) {
  const Portal<Real> portal = FindPortal<Real>(M);
  CoreTruth<Real> improved = truth;
  const Eigen::Vector3d n = Direction(portal.n);
  if (n.isZero(0)) return improved;
  const Enclosure overlap = M.OverlapAlong(Exactly<Bounded<Real>>(n)).enclosure();
  ImproveLower(-overlap.hi, n, &improved);
  if (truth.is_deep) SetSupportingPoints(M, &improved);
  if (portal.simplex.count == 0 || truth.is_deep) return improved;
  return Best(improved, ProvedBy(M, FindNearest(M, NearestOnSimplex(portal.simplex))));
}

}  // namespace

template <typename Real>
CoreTruth<Real> JudgeCores(const MinkowskiDifference& M) {
  if (IsZonotope(M.A().core) && IsZonotope(M.B().core)) return JudgeZonotopes<Real>(M);
  const CoreTruth<Real> truth = JudgeAny<Real>(M);
  // Where the other searches got all digits but the last few, there is nothing to gain.
  if (Width(truth.separation) <= 64 * kUlp * M.Size()) return truth;
  return ImprovedByPortal<Real>(M, truth);
}

template CoreTruth<DoubleDouble> JudgeCores(const MinkowskiDifference&);
template CoreTruth<Precise> JudgeCores(const MinkowskiDifference&);

}  // namespace touchstone::referee
