#include "reports/contacts/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "oracles/stated_tolerance.h"

namespace touchstone {
namespace {

struct SmallestFeature {
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Box& box) const { return box.half_extents.minCoeff(); }
  double operator()(const Capsule& capsule) const { return capsule.radius; }
  double operator()(const Cylinder& cylinder) const {
    return std::min(cylinder.radius, cylinder.half_length);
  }
  double operator()(const Cone& cone) const {
    return std::min(cone.radius, cone.half_height);
  }
  double operator()(const ConvexHull& hull) const { return BoundingRadius(hull); }
  double operator()(const HalfSpace&) const {
    return std::numeric_limits<double>::infinity();
  }
};

double SmallestFeatureOf(const ContactQuery& query) {
  return std::min(std::visit(SmallestFeature{}, query.A.shape),
                  std::visit(SmallestFeature{}, query.B.shape));
}

const Capability& CapabilityFor(const OracleInfo& oracle, const ContactQuery& query) {
  return oracle.For(KindOf(query.A.shape), KindOf(query.B.shape));
}

Tolerance SeparationTolerance(const OracleInfo& oracle, const Scenario& scenario,
                              const ContactTruth& truth) {
  const Capability& capability = CapabilityFor(oracle, scenario.contact);
  const double rounding = RoundingOf(oracle, scenario.contact);
  const double largest =
      std::max(std::abs(truth.separation.lo), std::abs(truth.separation.hi));
  // Without a relative error the product is skipped: the enclosure may be unbounded, and
  // 0 times infinity is a NaN.
  const double relative = capability.documented_relative_error > 0
                              ? capability.documented_relative_error * largest
                              : 0;
  Tolerance tolerance;
  tolerance.value =
      rounding + truth.input_rounding + capability.documented_error + relative;
  tolerance.because = fmt::format(
      "{} roundings of 2^{:.0f} on a scene of {:.3g} m, and {:.2g} m for the rounding of "
      "the input",
      kRoundings, std::log2(oracle.unit_roundoff), SceneSize(scenario.contact),
      truth.input_rounding);
  if (capability.documented_error + relative > 0) {
    tolerance.because +=
        fmt::format("; {:.2g} m documented by {}", capability.documented_error + relative,
                    capability.documented_by);
  }
  if (!oracle.tolerance.IsZero()) {
    tolerance.value += StatedFor(oracle, scenario.contact);
    tolerance.because +=
        fmt::format("; {:.2g} m granted, {} stated by {}",
                    StatedFor(oracle, scenario.contact), ToString(oracle.tolerance),
                    oracle.tolerance.by);
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
  return kRoundings * oracle.unit_roundoff * SceneSize(query);
}

double StatedFor(const OracleInfo& oracle, const ContactQuery& query) {
  // Without a share the product is skipped: a huge scene must not turn 0 into a NaN.
  const double share =
      oracle.tolerance.share > 0 ? oracle.tolerance.share * SceneSize(query) : 0;
  return oracle.tolerance.length + share;
}

Tolerances TolerancesOf(const OracleInfo& oracle, const Scenario& scenario,
                        const ContactTruth& truth) {
  const double size = SceneSize(scenario.contact);
  Tolerances tolerances;
  tolerances.separation = SeparationTolerance(oracle, scenario, truth);
  const double e = tolerances.separation.value;

  tolerances.apart = tolerances.separation;
  if (truth.separation.lo > 0) {
    const double tilted = size * e / truth.separation.lo;
    tolerances.apart.value += tilted;
    tolerances.apart.because += fmt::format(
        "; {:.2g} m for the direction between points {:.3g} m apart, each off by {:.2g} "
        "m",
        tilted, truth.separation.lo, e);
  }

  const double again = RoundingOf(oracle, scenario.contact) + truth.input_rounding;
  tolerances.excess = {
      tolerances.apart.value + again,
      fmt::format("{}; {:.2g} m more, since a direction is chosen among rounded ones",
                  tolerances.apart.because, again)};

  // Twice: once for the patch, whose slack is half of this value, and once for the
  // contact.
  tolerances.across = {
      2 * std::sqrt(2 * e * size),
      fmt::format("a depth off by {:.2g} m leaves the deepest point uncertain by "
                  "2 sqrt(2 * {:.2g} * {:.3g}) m across the normal",
                  e, e, size)};

  tolerances.angle = {e / SmallestFeatureOf(scenario.contact),
                      fmt::format("lengths off by {:.2g} m tilt a feature of {:.3g} m", e,
                                  SmallestFeatureOf(scenario.contact))};

  // A normal rotated by a given matrix is as long as that matrix makes it.
  tolerances.unit_normal = kNormalRoundings * oracle.unit_roundoff +
                           OrthonormalityDefect(scenario.contact.A.X_WB.R_WB) +
                           OrthonormalityDefect(scenario.contact.B.X_WB.R_WB);
  return tolerances;
}

}  // namespace touchstone
