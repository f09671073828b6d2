#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "reports/sweep/ask_block.h"
#include "tests/reports/sweep/spheres.h"

namespace touchstone {
namespace {

/** A block of spheres that touch, most of them by more than a rounding. */
constexpr QuestionSeries kBlock = {.family = Family::kDeep,
                                   .A = ShapeKind::kSphere,
                                   .B = ShapeKind::kSphere,
                                   .seed = 3,
                                   .first = 0,
                                   .count = kContactBlock};

/** Half of the depth is wrong in each question, by a convention. */
class ExaminationTest : public testing::Test {
 protected:
  /** Returns the results of the block as number `number` of its series. */
  OracleTally AskAs(std::uint64_t number) const {
    const SweepPlan plan{.series = {kBlock}, .subjects = {half_.get()}};
    return AskBlock(plan, {0, kBlock, number}).value().oracles.at(0);
  }

  const std::unique_ptr<Oracle> half_ = Spheres("half", 0.5);
  const OracleTally all_ = AskAs(kExaminedBlocks - 1);
  const OracleTally some_ = AskAs(kExaminedBlocks);
};

using Kind = std::tuple<MeasureKind, Verdict, Grade>;

/** Returns the counts whatever the cause. */
std::map<Kind, std::uint64_t> WithoutCauses(const FindingCounts& counts) {
  std::map<Kind, std::uint64_t> sums;
  for (const auto& [kind, count] : counts)
    sums[{kind.measure, kind.verdict, kind.grade}] += count;
  return sums;
}

/** Returns the counts of answers proved wrong whose cause was sought. Others have none,
 or are defects: an answer that is a NaN needs no examination. */
std::map<Kind, std::uint64_t> ExaminedOf(const OracleTally& tally) {
  std::map<Kind, std::uint64_t> sums;
  for (const auto& [kind, count] : tally.answers) {
    if (kind.verdict == Verdict::kFail && kind.cause != Cause::kNotExamined)
      sums[{kind.measure, kind.verdict, kind.grade}] += count;
  }
  return sums;
}

TEST_F(ExaminationTest, SeeksEveryCauseInTheFirstBlocksOfASeries) {
  std::uint64_t failed = 0;
  for (const auto& [kind, count] : all_.answers) {
    if (!IsFailure(kind.verdict)) continue;
    EXPECT_NE(kind.cause, Cause::kNotExamined);
    failed += count;
  }
  EXPECT_GT(failed, 10 * kExaminedPerKind);
}

TEST_F(ExaminationTest, SeeksTheCausesOfSomeFailuresOfEachKindInLaterBlocks) {
  for (const auto& [kind, count] : ExaminedOf(all_))
    EXPECT_EQ(ExaminedOf(some_)[kind], std::min<std::uint64_t>(count, kExaminedPerKind));
}

// The limit changes no verdict and drops no failure.
TEST_F(ExaminationTest, CountsEveryFailureWithItsVerdictMeasureAndGrade) {
  EXPECT_EQ(FailureCount(some_), FailureCount(all_));
  EXPECT_EQ(WithoutCauses(some_.answers), WithoutCauses(all_.answers));
  EXPECT_EQ(WithoutCauses(some_.findings), WithoutCauses(all_.findings));
  EXPECT_EQ(some_.asked, all_.asked);
  EXPECT_EQ(some_.verified, all_.verified);
  EXPECT_EQ(some_.sketches, all_.sketches);
  EXPECT_EQ(some_.worst, all_.worst);
}

TEST_F(ExaminationTest, FindsTheSameCausesAsIfAllWereExamined) {
  std::map<std::uint64_t, FindingKind> kinds;
  for (const auto& [of_cause, failures] : all_.failures) {
    for (const FailedQuestion& failure : failures) kinds[failure.question] = failure.kind;
  }
  std::size_t examined = 0;
  for (const auto& [of_cause, failures] : some_.failures) {
    for (const FailedQuestion& failure : failures) {
      if (of_cause.cause == Cause::kNotExamined) continue;
      const auto found = kinds.find(failure.question);
      if (found == kinds.end()) continue;  // Kept only where fewer are of its cause.
      EXPECT_EQ(failure.kind, found->second);
      ++examined;
    }
  }
  EXPECT_GE(examined, kFailuresKept);
}

// A cause is sought where a user looks first.
TEST_F(ExaminationTest, SeeksTheCauseOfTheGravestFailureOfEachMeasureAndGrade) {
  std::map<Kind, const FailedQuestion*> gravest;
  for (const auto& [kind, failures] : some_.failures) {
    const FailedQuestion*& of_kind = gravest[{kind.measure, kind.verdict, kind.grade}];
    if (of_kind == nullptr || failures.front().share > of_kind->share)
      of_kind = &failures.front();
  }
  ASSERT_FALSE(gravest.empty());
  for (const auto& [kind, failure] : gravest)
    EXPECT_NE(failure->kind.cause, Cause::kNotExamined) << failure->proof;
}

TEST_F(ExaminationTest, KeepsFailuresThatAreNotExamined) {
  std::size_t kept = 0;
  for (const auto& [of_cause, failures] : some_.failures) {
    if (of_cause.cause != Cause::kNotExamined) continue;
    kept += failures.size();
    for (const FailedQuestion& failure : failures) EXPECT_NE(failure.proof, "");
  }
  EXPECT_GE(kept, kFailuresKept);
}

}  // namespace
}  // namespace touchstone
