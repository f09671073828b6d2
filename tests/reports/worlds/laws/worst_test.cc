#include "reports/worlds/law_support/worst.h"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

CitingProof Named(std::string_view name) {
  return {std::string(name), {}};
}

/** A number and its tolerance, and whether it is beyond. */
struct Number {
  double value;
  double tolerance;
  bool is_beyond;
};

/** From the least grave to the gravest. */
const Number kByGravity[] = {
    {0, 0, false}, {1, 2, false}, {3, 2, true}, {1, 0, true}, {kNoNumber, 2, true},
};

TEST(Worst, IsTheGravestNumberInAnyOrder) {
  for (const Number& less : kByGravity) {
    for (const Number& more : kByGravity) {
      if (&more <= &less) continue;
      for (const bool less_first : {true, false}) {
        Worst worst(MeasureKind::kExcess, "");
        const auto take = [&](const Number& number, std::string_view name) {
          worst.Take(number.value, number.tolerance, [&] { return Named(name); });
        };
        if (less_first) take(less, "less");
        take(more, "more");
        if (!less_first) take(less, "less");
        EXPECT_EQ(worst.finding().proof, "more") << less.value << ' ' << more.value;
        EXPECT_EQ(worst.IsBeyond(), more.is_beyond) << less.value << ' ' << more.value;
      }
    }
  }
}

TEST(Worst, KnowsTheFirstMomentBeyondItsTolerance) {
  Worst worst(MeasureKind::kExcess, "");
  const auto take = [&](double value, double time) {
    worst.Take(value, 1, [&] { return Citing("at {:.6g} s", CitedTime{time}); });
  };
  take(0.5, 1);
  EXPECT_FALSE(worst.finding().cited.first_time);
  take(2, 2);
  take(3, 3);
  take(2.5, 4);
  EXPECT_EQ(worst.finding().cited.time, 3);
  EXPECT_EQ(worst.finding().cited.first_time, 2);
  // Another body, which is looked at later, breaks earlier and worse.
  take(4, 1.5);
  EXPECT_EQ(worst.finding().cited.first_time, 1.5);
}

TEST(WorstOfEach, KnowsTheFirstMomentOfAllSubjects) {
  const std::vector<LawFinding> found = WorstOfEach({0, 1}, [](int subject) {
    LawFinding finding;
    finding.measure = MeasureKind::kExcess;
    finding.value = subject == 0 ? 3 : 2;
    finding.tolerance.value = 1;
    finding.cited.time = subject == 0 ? 5 : 4;
    finding.cited.first_time = finding.cited.time;
    return std::vector<LawFinding>{finding};
  });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].cited.time, 5);
  EXPECT_EQ(found[0].cited.first_time, 4);
}

TEST(WorstOfEach, IsTheGravestNumberInAnyOrder) {
  for (const Number& less : kByGravity) {
    for (const Number& more : kByGravity) {
      if (&more <= &less) continue;
      for (const bool less_first : {true, false}) {
        const auto judge = [&](int subject) {
          const Number& number = (subject == 0) == less_first ? less : more;
          LawFinding finding;
          finding.measure = MeasureKind::kExcess;
          finding.value = number.value;
          finding.tolerance.value = number.tolerance;
          finding.proof = &number == &more ? "more" : "less";
          return std::vector<LawFinding>{finding};
        };
        const std::vector<LawFinding> worst = WorstOfEach({0, 1}, judge);
        ASSERT_EQ(worst.size(), 1);
        EXPECT_EQ(worst.front().proof, "more") << less.value << ' ' << more.value;
      }
    }
  }
}

// A number that is larger than the worst one, and smaller next to its own tolerance.
TEST(Worst, KnowsTheLargestNumberWithinItsTolerance) {
  Worst worst(MeasureKind::kExcess, "why");
  const auto take = [&](double value, double tolerance) {
    worst.Take(value, tolerance, [] { return Named(""); });
  };
  take(0.5, 0.6);
  take(2, 8);
  take(1, 9);
  EXPECT_EQ(worst.finding().value, 0.5);
  EXPECT_EQ(worst.finding().largest.value, 2);
  EXPECT_EQ(worst.finding().largest.tolerance, 8);
  take(6, 5);
  EXPECT_TRUE(worst.IsBeyond());
  EXPECT_EQ(worst.finding().value, 6);
  EXPECT_EQ(worst.finding().largest.value, 2);
}

TEST(WorstOfEach, KnowsTheLargestOfAllSubjects) {
  for (const int larger : {0, 1}) {
    const auto found = WorstOfEach({0, 1}, [&](int subject) {
      LawFinding finding;
      finding.measure = MeasureKind::kExcess;
      finding.value = subject == larger ? 0.1 : 0.9;
      finding.tolerance.value = 1;
      finding.largest = subject == larger ? Within{3, 40} : Within{2, 30};
      return std::vector<LawFinding>{finding};
    });
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].value, 0.9);
    EXPECT_EQ(found[0].largest.value, 3);
    EXPECT_EQ(found[0].largest.tolerance, 40);
  }
}

TEST(Worst, SharesNothingFiniteIfItIsNoNumber) {
  Worst worst(MeasureKind::kExcess, "");
  worst.Take(kNoNumber, 2, [] { return Named(""); });
  EXPECT_TRUE(std::isinf(worst.share()));
}

}  // namespace
}  // namespace touchstone
