#include "reports/contacts/consensus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

/** One oracle's vote. */
struct Says {
  std::string family;
  double separation;  ///< [m]
};

/** Returns the verdicts after a vote on separations that the truth, [-0.3, 0.1] m, cannot
 decide. */
std::vector<Verdict> Settled(const std::vector<Says>& voters, MeasureKind measure) {
  ScenarioResult result;
  result.scenario.id = "contact/x";
  result.scenario.contact = SphereInBoxFace(1e-3).query;
  result.truth.separation = {-0.3, 0.1};
  std::vector<OracleInfo> oracles;
  std::vector<Finding> findings;
  for (const Says& says : voters) {
    OracleInfo info;
    info.name = "oracle " + std::to_string(oracles.size());
    for (auto& row : info.capabilities) {
      for (Capability& capability : row) capability.family = says.family;
    }
    oracles.push_back(info);
    ContactAnswer answer;
    answer.status = AnswerStatus::kAnswered;
    answer.touching = says.separation <= 0;
    answer.separation = says.separation;
    result.answers.push_back(answer);
    Finding finding{};
    finding.scenario = result.scenario.id;
    finding.oracle = info.name;
    finding.reference = "referee";
    finding.measure = measure;
    finding.verdict = Verdict::kUndecidable;
    findings.push_back(finding);
  }
  SettleByConsensus(result, oracles, findings);
  std::vector<Verdict> verdicts;
  for (const Finding& finding : findings) {
    verdicts.push_back(finding.verdict);
    EXPECT_EQ(finding.verdict == Verdict::kDisagree, !finding.proof.empty());
    // They differ by 10 cm or more; the sphere has an extent of 50 cm.
    EXPECT_EQ(finding.grade,
              finding.verdict == Verdict::kDisagree ? Grade::kGross : Grade::kNone);
  }
  return verdicts;
}

constexpr Verdict kDisagree = Verdict::kDisagree;
constexpr Verdict kUndecidable = Verdict::kUndecidable;

TEST(Consensus, CountsFamiliesAndNotLibraries) {
  // Three libraries of one family against two families: the three are outvoted.
  EXPECT_THAT(
      Settled({{"sat", -0.2}, {"sat", -0.2}, {"sat", -0.2}, {"gjk", -0.1}, {"mpr", -0.1}},
              MeasureKind::kSeparationError),
      testing::ElementsAre(kDisagree, kDisagree, kDisagree, kUndecidable, kUndecidable));
}

TEST(Consensus, MakesBothOfTwoThatDifferDisagree) {
  EXPECT_THAT(Settled({{"sat", -0.2}, {"gjk", -0.1}}, MeasureKind::kSeparationError),
              testing::ElementsAre(kDisagree, kDisagree));
}

TEST(Consensus, LeavesASingleFamilyUndecided) {
  EXPECT_THAT(Settled({{"sat", -0.2}, {"sat", -0.1}}, MeasureKind::kSeparationError),
              testing::ElementsAre(kUndecidable, kUndecidable));
}

TEST(Consensus, SettlesTouchingWhereTheTruthReachesAcrossZero) {
  EXPECT_THAT(
      Settled({{"sat", -0.2}, {"gjk", 0.05}, {"mpr", -0.1}}, MeasureKind::kTouching),
      testing::ElementsAre(kUndecidable, kDisagree, kUndecidable));
}

}  // namespace
}  // namespace touchstone
