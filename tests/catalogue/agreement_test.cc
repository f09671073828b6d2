#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/catalogue/the_catalogue.h"

// What the author of a scenario derived is what the referee certifies.

namespace touchstone {
namespace {

/* How far the doubles of a file may be from the configuration that was meant, as a
 multiple of unit roundoff times scene size.

 Each quaternion component is rounded (u/2 relative) and the matrix computed from it in
 double: an entry is off by at most 4u + 4u. A point of a body at radius r thus moves by
 at most 8u · 3r, its position rounds by √3 u |p|_inf: below 24u · SceneSize a body, 48u
 for both. An expected normal rounds by √3 u / 2 over a lever of at most 2√3 SceneSize: 3u
 more. */
constexpr double kRounding = 64 * 0x1p-53;

/** A scenario and what is certain of it. */
struct Judged {
  const Scenario* scenario;
  ContactTruth truth;
  /** How far the written separation may be from that of the written poses. [m] */
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
      const ContactTruth truth = JudgeContact(scenario->contact);
      all.push_back({scenario, truth, SlackOf(*scenario, truth)});
    }
    return all;
  }();
  return judged;
}

TEST(ExpectedSeparation, IsWhatTheRefereeCertifies) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    const double expected = *scenario->expect.separation;
    EXPECT_LE(truth.separation.lo, expected + slack) << scenario->id;
    EXPECT_GE(truth.separation.hi, expected - slack) << scenario->id;
  }
}

// An agreement says as much as the enclosure is narrow. Curved surfaces are enclosed by
// iteration: to a millionth of the expected value at worst.
TEST(ExpectedSeparation, IsCertifiedToRoundingOrToAMillionthOfItselfOnCurvedSurfaces) {
  constexpr double kCurved = 1e-6;
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    const bool curved = truth.method == "bounds";
    const double share = curved ? kCurved * std::abs(*scenario->expect.separation) : 0;
    EXPECT_LE(truth.separation.hi - truth.separation.lo, std::max(slack, share))
        << scenario->id;
  }
}

TEST(ExpectedVerdict, IsCertainWhereItIsGiven) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    if (!scenario->expect.touching) continue;
    EXPECT_EQ(truth.touching,
              *scenario->expect.touching ? Touching::kTouching : Touching::kApart)
        << scenario->id;
  }
}

TEST(ExpectedVerdict, IsLeftOutOnlyWhereTheGapIsRounding) {
  for (const auto& [scenario, truth, slack] : JudgedCatalogue()) {
    if (scenario->expect.touching) continue;
    EXPECT_LE(std::abs(*scenario->expect.separation), slack) << scenario->id;
  }
}

TEST(ExpectedNormals, EachSeparateByTheExpectedDepthOrGap) {
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
