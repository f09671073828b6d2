#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/catalogue/the_catalogue.h"

// The values that the author of a scenario derived agree with the certified truth.

namespace touchstone {
namespace {

/* Largest deviation of the doubles in a file from the intended configuration, as a
 multiple of unit roundoff times scene size.

 Each quaternion component is rounded (u/2 relative), and the matrix is computed from it
 in double: the error of an entry is at most 4u + 4u. A point of a body at radius r thus
 moves by at most 8u · 3r, and the rounding of the position is √3 u |p|_inf. That is below
 24u · SceneSize for one body and 48u · SceneSize for both. The rounding of an expected
 normal is √3 u / 2 over a lever of at most 2√3 SceneSize, which adds 3u. */
constexpr double kRounding = 64 * 0x1p-53;

/** A scenario and its certified truth. */
struct Judged {
  const Scenario* scenario;
  ContactTruth truth;
  /** Largest deviation of the expected separation from that of the poses. [m] */
  double slack;
};

double SlackOf(const Scenario& scenario, const ContactTruth& truth) {
  double slack = kRounding * SceneSize(scenario.contact) + truth.input_rounding;
  if (scenario.tolerance) slack += scenario.tolerance->separation;
  return slack;
}

const std::vector<Judged>& JudgedCatalogue() {
  static const std::vector<Judged> judged = [] {
    std::vector<Judged> all;
    for (const auto& [id, scenario] : Below("contact/")) {
      const ContactTruth truth = ComputeContactTruth(scenario->contact);
      all.push_back({scenario, truth, SlackOf(*scenario, truth)});
    }
    return all;
  }();
  return judged;
}

TEST(ExpectedSeparation, AgreesWithTheCertifiedTruth) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    const double expected = *scenario->expect.separation;
    EXPECT_LE(truth.separation.lo, expected + slack) << scenario->id;
    EXPECT_GE(truth.separation.hi, expected - slack) << scenario->id;
  }
}

// The narrower the enclosure, the more an agreement proves. Curved surfaces are enclosed
// by iteration, to at worst a millionth of the expected value.
TEST(ExpectedSeparation, IsCertifiedToRoundingOrToOneMillionthOnCurvedSurfaces) {
  constexpr double kCurved = 1e-6;
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    const bool curved = truth.method == "bounds";
    const double share = curved ? kCurved * std::abs(*scenario->expect.separation) : 0;
    EXPECT_LE(truth.separation.hi - truth.separation.lo, std::max(slack, share))
        << scenario->id;
  }
}

TEST(ExpectedVerdict, IsCertainIfGiven) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    if (!scenario->expect.touching) continue;
    EXPECT_EQ(truth.touching,
              *scenario->expect.touching ? Touching::kTouching : Touching::kApart)
        << scenario->id;
  }
}

TEST(ExpectedVerdict, IsOmittedOnlyIfTheGapIsWithinRounding) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    if (scenario->expect.touching) continue;
    EXPECT_LE(std::abs(*scenario->expect.separation), slack) << scenario->id;
  }
}

TEST(ExpectedNormals, SeparateTheBodiesByTheExpectedDepthOrGap) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    const double expected = -*scenario->expect.separation;
    for (const Eigen::Vector3d& n_AB_W : scenario->expect.normals) {
      const Enclosure overlap = Overlap(scenario->contact, n_AB_W);
      EXPECT_LE(overlap.lo, expected + slack) << scenario->id;
      EXPECT_GE(overlap.hi, expected - slack) << scenario->id;
    }
  }
}

TEST(ExpectedContacts, AreTheFewestThatSpanThePatch) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    if (!scenario->expect.contacts) continue;
    for (const Eigen::Vector3d& n_AB_W : scenario->expect.normals) {
      const ContactPatch patch =
          PatchAlong(scenario->contact, n_AB_W, *scenario->expect.separation, slack);
      EXPECT_EQ(patch.least_contacts, *scenario->expect.contacts) << scenario->id;
    }
  }
}

}  // namespace
}  // namespace touchstone
