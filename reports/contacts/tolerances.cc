#include "reports/contacts/tolerances.h"

#include <algorithm>
#include <cmath>

#include "reports/contacts/body_size.h"

namespace touchstone {
namespace {

/** Returns whether both positions are numbers of an arithmetic of unit roundoff `u`. */
bool ArePositionsRepresentable(const ContactQuery& query, double u) {
  if (u <= 0x1p-53) return true;
  for (const Body* body : {&query.A, &query.B}) {
    for (const double x : body->X_WB.p_WB) {
      if (static_cast<double>(static_cast<float>(x)) != x) return false;
    }
  }
  return u <= 0x1p-24;
}

/** Returns the size of the scene as an engine sees it that subtracts the positions first.
 [m] */
double RelativeSize(const ContactQuery& query) {
  const double distance =
      (query.B.X_WB.p_WB - query.A.X_WB.p_WB).lpNorm<Eigen::Infinity>();
  return distance +
         std::max(BoundingRadius(query.A.shape), BoundingRadius(query.B.shape));
}

bool HasHalfSpace(const ContactQuery& query) {
  return KindOf(query.A.shape) == ShapeKind::kHalfSpace ||
         KindOf(query.B.shape) == ShapeKind::kHalfSpace;
}

/** Returns the most by which tilting a normal by a radian changes the overlap along it:
 the sum of the extents of both bodies. A half-space is cut off at the size of the scene,
 see OverlapAlong(). [m] */
double LeverOf(const ContactQuery& query) {
  return SumOfExtents(query) + (HasHalfSpace(query) ? 2 * SceneSize(query) : 0);
}

/** Same as RoundedSize() for a scene of size `size`. [m] */
double RoundedSizeIn(double size, const OracleInfo& oracle, const ContactQuery& query) {
  const bool is_relative = oracle.subtracts_first && !HasHalfSpace(query) &&
                           ArePositionsRepresentable(query, oracle.unit_roundoff);
  return is_relative ? std::min(size, RelativeSize(query)) : size;
}

}  // namespace

double RoundedSize(const OracleInfo& oracle, const ContactQuery& query) {
  return RoundedSizeIn(SceneSize(query), oracle, query);
}

double RoundingOf(const OracleInfo& oracle, const ContactQuery& query) {
  return kRoundings * oracle.unit_roundoff * RoundedSize(oracle, query);
}

double DocumentedFor(const OracleInfo& oracle, const ContactQuery& query,
                     const ContactTruth& truth) {
  const Capability& capability = oracle.For(KindOf(query.A.shape), KindOf(query.B.shape));
  const double largest =
      std::max(std::abs(truth.separation.lo), std::abs(truth.separation.hi));
  // Without a relative error the product is skipped: the enclosure may be unbounded, and
  // 0 times infinity is a NaN.
  const double relative = capability.documented_relative_error > 0
                              ? capability.documented_relative_error * largest
                              : 0;
  return capability.documented_error + relative;
}

double StatedFor(const OracleInfo& oracle, const ContactQuery& query) {
  // Without a share the product is skipped: a huge scene must not turn 0 into a NaN.
  const double share =
      oracle.tolerance.share > 0 ? oracle.tolerance.share * SceneSize(query) : 0;
  return oracle.tolerance.length + share;
}

Tolerances TolerancesOf(const OracleInfo& oracle, const Scenario& scenario,
                        const ContactTruth& truth, bool touching) {
  return TolerancesOf(oracle, scenario.contact,
                      scenario.tolerance ? scenario.tolerance->separation : 0, truth,
                      touching);
}

Tolerances TolerancesOf(const OracleInfo& oracle, const ContactQuery& query,
                        double granted, const ContactTruth& truth, bool touching) {
  // Tolerances are derived a hundred times for a question of a sweep.
  const double size = SceneSize(query);
  const double rounding =
      kRoundings * oracle.unit_roundoff * RoundedSizeIn(size, oracle, query);
  const double documented = DocumentedFor(oracle, query, truth);
  const double stated = StatedFor(oracle, query);
  const auto length = [&](double roundings) {
    return roundings + truth.input_rounding + documented + stated + granted;
  };
  Tolerances tolerances;
  tolerances.separation = length(rounding);
  tolerances.position = length(kRoundings * oracle.unit_roundoff * size);
  const double e = tolerances.separation;

  tolerances.apart = e;
  if (truth.separation.lo > 0 && !touching)
    tolerances.apart += LeverOf(query) * std::min(1.0, e / truth.separation.lo);

  tolerances.excess = tolerances.apart + (rounding + truth.input_rounding);

  // Twice: once for the patch, whose slack is half of this value, and once for the
  // contact.
  const double extent = SmallerExtent(query);
  tolerances.across = std::min(2 * std::sqrt(2 * tolerances.position * extent), extent);

  const double feature = SmallestFeature(query);
  tolerances.angle = e / feature;

  // A normal rotated by a given matrix is as long as that matrix makes it.
  tolerances.unit_normal = kNormalRoundings * oracle.unit_roundoff +
                           OrthonormalityDefect(query.A.X_WB.R_WB) +
                           OrthonormalityDefect(query.B.X_WB.R_WB);
  tolerances.fine = kFine * (feature + std::max(0.0, truth.separation.lo));
  return tolerances;
}

}  // namespace touchstone
