#include "reports/sweep/tally.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "reports/sweep/block_set.h"

namespace touchstone {
namespace {

/** Returns a tally of one oracle as a block gives it: of the questions [first, first +
 n), with equal values among them, so that ties occur. */
SeriesTally OfQuestions(std::uint64_t first, std::uint64_t n) {
  SeriesTally tally;
  OracleTally& oracle = tally.oracles.emplace_back();
  oracle.asked = n;
  oracle.touching = n / 2;
  for (std::uint64_t i = first; i < first + n; ++i) {
    const double value = 1e-3 * static_cast<double>(*rc::gen::inRange(0, 6));
    const auto measure = *rc::gen::element(MeasureKind::kExcess, MeasureKind::kSwap);
    const auto cause = *rc::gen::element(Cause::kDefect, Cause::kPrecision);
    const std::string law = *rc::gen::element<std::string>("", "pendulum");
    const std::string ending = *rc::gen::element<std::string>("", "killed by SIGSEGV.");
    const FindingKind kind{measure, Verdict::kFail, Grade::kLarge, cause, law, ending};
    ++oracle.answers[kind];
    ++oracle.findings[kind];
    oracle.sketches[{measure, law}].Add(value);
    Insert({i, value, 1e-3, value / 1e-3, value, Verdict::kFail, Grade::kLarge},
           oracle.worst[{measure, law}]);
    Insert(FailedQuestion{i, kind, value, 1e-3, value, "proof", "file"},
           oracle.failures[kind]);
  }
  return tally;
}

SeriesTally Sum(const SeriesTally& a, const SeriesTally& b) {
  SeriesTally sum = a;
  Merge(b, sum);
  return sum;
}

RC_GTEST_PROP(Tally, MergesInAnyOrderAndGroupingToTheSame, ()) {
  const SeriesTally a = OfQuestions(0, *rc::gen::inRange<std::uint64_t>(0, 30));
  const SeriesTally b = OfQuestions(30, *rc::gen::inRange<std::uint64_t>(0, 30));
  const SeriesTally c = OfQuestions(60, *rc::gen::inRange<std::uint64_t>(0, 30));
  RC_ASSERT(Sum(a, b) == Sum(b, a));
  RC_ASSERT(Sum(Sum(a, b), c) == Sum(a, Sum(b, c)));
  RC_ASSERT(Sum(SeriesTally(), a) == a);
}

TEST(Tally, KeepsTheWorstAndOfEqualOnesTheFirst) {
  std::vector<WorstFinding> worst;
  for (std::uint64_t i = 0; i < 100; ++i)
    Insert({i, 0, 1, static_cast<double>(i % 10), 0, Verdict::kPass, Grade::kNone},
           worst);
  ASSERT_EQ(worst.size(), kWorstKept);
  for (std::size_t i = 0; i < kWorstKept; ++i) {
    EXPECT_EQ(worst[i].tolerances, 9);
    EXPECT_EQ(worst[i].question, 10 * i + 9);
  }
}

TEST(Tally, KeepsTheGravestFailuresOfEachKindAndCountsAll) {
  OracleTally tally;
  for (std::uint64_t i = 100; i > 0; --i) {
    const FindingKind kind{MeasureKind::kExcess, Verdict::kFail, Grade::kSmall,
                           i % 2 == 0 ? Cause::kDefect : Cause::kTie};
    ++tally.answers[kind];
    const double share = 0.001 * static_cast<double>(i % 10);
    Insert(FailedQuestion{i, kind, 0, 0, share, "", ""}, tally.failures[kind]);
  }
  EXPECT_EQ(FailureCount(tally), 100U);
  EXPECT_EQ(tally.failures.size(), 2U);
  for (const auto& [kind, failures] : tally.failures) {
    ASSERT_EQ(failures.size(), kFailuresKept);
    // The share is largest in every tenth question; of these the first are kept.
    const std::uint64_t first = kind.cause == Cause::kDefect ? 8 : 9;
    for (std::size_t f = 0; f < kFailuresKept; ++f)
      EXPECT_EQ(failures[f].question, first + 10 * f);
  }
  ASSERT_NE(GravestFailure(tally), nullptr);
  EXPECT_EQ(GravestFailure(tally)->question, 9U);
}

TEST(Tally, KeepsFailuresOfEachGradeAndEnding) {
  OracleTally tally;
  const auto fail = [&](std::uint64_t question, Verdict verdict, Grade grade,
                        const std::string& ending) {
    const FindingKind kind{MeasureKind::kAnswering, verdict, grade,
                           Cause::kDefect,          "",      ending};
    Insert(FailedQuestion{question, kind, 0, 0, 0, "", ""}, tally.failures[kind]);
  };
  for (std::uint64_t i = 0; i < 50; ++i)
    fail(i, Verdict::kCrashed, Grade::kUnusable, "killed by SIGSEGV.");
  fail(50, Verdict::kCrashed, Grade::kUnusable, "aborted: gjk.h:12: Assertion `a'.");
  fail(51, Verdict::kFail, Grade::kGross, "");
  fail(52, Verdict::kFail, Grade::kRounding, "");
  EXPECT_EQ(tally.failures.size(), 4U);
  ASSERT_NE(GravestFailure(tally), nullptr);
  EXPECT_EQ(GravestFailure(tally)->question, 0U);
}

TEST(Sketch, BinsDifferByAnEighthAtMost) {
  Sketch::Bin last = 0;
  for (int i = -69'000; i < 69'000; ++i) {
    const double value = std::pow(1.01, i);  // From 1e-298 to 1e298.
    const Sketch::Bin bin = Sketch::BinOf(value);
    EXPECT_GE(bin, last);
    EXPECT_LE(Sketch::LeastOf(bin), value);
    EXPECT_GT(Sketch::LeastOf(bin + 1), value);
    EXPECT_LE(Sketch::LeastOf(bin + 1), 1.125 * Sketch::LeastOf(bin));
    last = bin;
  }
}

TEST(Sketch, ReturnsQuantilesToItsAccuracy) {
  Sketch sketch;
  EXPECT_EQ(sketch.Quantile(0.5), 0);
  for (int i = 1; i <= 1000; ++i) sketch.Add(i);
  EXPECT_EQ(sketch.count(), 1000U);
  // The value of rank 500 is 500, and that of rank 1000 is 1000.
  EXPECT_GE(sketch.Quantile(0.5), 500 / 1.125);
  EXPECT_LE(sketch.Quantile(0.5), 500);
  EXPECT_GE(sketch.Quantile(1), 1000 / 1.125);
  EXPECT_LE(sketch.Quantile(1), 1000);
}

TEST(Sketch, CountsValuesThatAreNoNumbersAtItsEnds) {
  EXPECT_EQ(Sketch::LeastOf(Sketch::BinOf(-1)), 0);
  EXPECT_EQ(Sketch::BinOf(-0.0), Sketch::BinOf(0));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Sketch::LeastOf(Sketch::BinOf(infinity)), infinity);
  EXPECT_EQ(Sketch::BinOf(std::numeric_limits<double>::quiet_NaN()),
            Sketch::BinOf(infinity));
}

TEST(BlockSet, JoinsRangesAndRefusesABlockTwice) {
  BlockSet set;
  EXPECT_TRUE(set.Add(4, 6));
  EXPECT_TRUE(set.Add(0, 1));
  EXPECT_FALSE(set.Add(6, 8));
  EXPECT_FALSE(set.Add(2, 9));
  EXPECT_FALSE(set.Add(5, 5));
  EXPECT_FALSE(set.Add(1, 2));
  EXPECT_EQ(set.FirstMissing(10), 2U);
  EXPECT_TRUE(set.Add(2, 3));
  EXPECT_EQ(set.ranges().size(), 1U);
  EXPECT_EQ(set.size(), 7U);
  EXPECT_FALSE(set.FirstMissing(7));
  EXPECT_EQ(set.FirstMissing(8), 7U);
  EXPECT_TRUE(set.Contains(6));
  EXPECT_FALSE(set.Contains(7));
}

}  // namespace
}  // namespace touchstone
