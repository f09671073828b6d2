#include "reports/contacts/tolerances.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "oracles/stated_tolerance.h"
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

/** Returns the size of which the lengths of `oracle` are rounded. [m] */
double RoundedSize(const OracleInfo& oracle, const ContactQuery& query) {
  const double size = SceneSize(query);
  const bool is_relative = oracle.subtracts_first && !HasHalfSpace(query) &&
                           ArePositionsRepresentable(query, oracle.unit_roundoff);
  return is_relative ? std::min(size, RelativeSize(query)) : size;
}

const Capability& CapabilityFor(const OracleInfo& oracle, const ContactQuery& query) {
  return oracle.For(KindOf(query.A.shape), KindOf(query.B.shape));
}

/** Returns the most by which tilting a normal by a radian changes the overlap along it:
 the sum of the extents of both bodies. A half-space is cut off at the size of the scene,
 see OverlapAlong(). [m] */
double LeverOf(const ContactQuery& query) {
  return SumOfExtents(query) + (HasHalfSpace(query) ? 2 * SceneSize(query) : 0);
}

/** Returns the tolerance of a length for roundings of `size`. [m] */
Tolerance LengthTolerance(const OracleInfo& oracle, const Scenario& scenario,
                          const ContactTruth& truth, double size) {
  const Capability& capability = CapabilityFor(oracle, scenario.contact);
  const double largest =
      std::max(std::abs(truth.separation.lo), std::abs(truth.separation.hi));
  // Without a relative error the product is skipped: the enclosure may be unbounded, and
  // 0 times infinity is a NaN.
  const double relative = capability.documented_relative_error > 0
                              ? capability.documented_relative_error * largest
                              : 0;
  const double documented = capability.documented_error + relative;
  Tolerance tolerance;
  tolerance.value =
      kRoundings * oracle.unit_roundoff * size + truth.input_rounding + documented;
  tolerance.because = fmt::format(
      "{} roundings of 2^{:.0f} on a scene of {:.3g} m, and {:.2g} m for the rounding of "
      "the input",
      kRoundings, std::log2(oracle.unit_roundoff), size, truth.input_rounding);
  if (documented > 0) {
    tolerance.because += fmt::format(
        "; {:.2g} m, {:.2g} of the smallest feature, documented by {}", documented,
        documented / SmallestFeature(scenario.contact), capability.documented_by);
  }
  if (!oracle.tolerance.IsZero()) {
    tolerance.value += StatedFor(oracle, scenario.contact);
    tolerance.because += fmt::format("; {:.2g} m granted, {} stated by {}",
                                     StatedFor(oracle, scenario.contact),
                                     ToString(oracle.tolerance), oracle.tolerance.by);
  }
  if (scenario.tolerance) {
    tolerance.value += scenario.tolerance->separation;
    tolerance.because +=
        fmt::format("; {:.2g} m granted by the scenario: {}",
                    scenario.tolerance->separation, scenario.tolerance->because);
  }
  return tolerance;
}

}  // namespace

double RoundingOf(const OracleInfo& oracle, const ContactQuery& query) {
  return kRoundings * oracle.unit_roundoff * RoundedSize(oracle, query);
}

double StatedFor(const OracleInfo& oracle, const ContactQuery& query) {
  // Without a share the product is skipped: a huge scene must not turn 0 into a NaN.
  const double share =
      oracle.tolerance.share > 0 ? oracle.tolerance.share * SceneSize(query) : 0;
  return oracle.tolerance.length + share;
}

Tolerances TolerancesOf(const OracleInfo& oracle, const Scenario& scenario,
                        const ContactTruth& truth, bool touching) {
  const ContactQuery& query = scenario.contact;
  Tolerances tolerances;
  tolerances.separation =
      LengthTolerance(oracle, scenario, truth, RoundedSize(oracle, query));
  tolerances.position = LengthTolerance(oracle, scenario, truth, SceneSize(query));
  const double e = tolerances.separation.value;

  tolerances.apart = tolerances.separation;
  if (truth.separation.lo > 0 && !touching) {
    const double tilted = LeverOf(query) * std::min(1.0, e / truth.separation.lo);
    tolerances.apart.value += tilted;
    tolerances.apart.because += fmt::format(
        "; {:.2g} m for the direction between points {:.3g} m apart, each off by {:.2g} "
        "m",
        tilted, truth.separation.lo, e);
  }

  const double again = RoundingOf(oracle, query) + truth.input_rounding;
  tolerances.excess = {
      tolerances.apart.value + again,
      fmt::format("{}; {:.2g} m more, since a direction is chosen among rounded ones",
                  tolerances.apart.because, again)};

  // Twice: once for the patch, whose slack is half of this value, and once for the
  // contact.
  const double extent = SmallerExtent(query);
  const double off = tolerances.position.value;
  tolerances.across = {
      std::min(2 * std::sqrt(2 * off * extent), extent),
      fmt::format("a depth off by {:.2g} m leaves the deepest point of a body {:.3g} m "
                  "wide uncertain by 2 sqrt(2 * {:.2g} * {:.3g}) m across the normal",
                  off, extent, off, extent)};

  tolerances.angle = {e / SmallestFeature(query),
                      fmt::format("lengths off by {:.2g} m tilt a feature of {:.3g} m", e,
                                  SmallestFeature(query))};

  // A normal rotated by a given matrix is as long as that matrix makes it.
  tolerances.unit_normal = kNormalRoundings * oracle.unit_roundoff +
                           OrthonormalityDefect(query.A.X_WB.R_WB) +
                           OrthonormalityDefect(query.B.X_WB.R_WB);
  tolerances.fine = kFine * (SmallestFeature(query) + std::max(0.0, truth.separation.lo));
  return tolerances;
}

}  // namespace touchstone
