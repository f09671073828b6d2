#include "reports/ledger/bounds_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> Complaints(std::string_view text) {
  std::vector<std::string> complaints;
  for (const Diagnostic& d : ReadBounds(text, "known.bounds").diagnostics) {
    complaints.push_back(ToString(d));
  }
  return complaints;
}

TEST(ReadBounds, ReadsNumbersVerdictsAndLaws) {
  const BoundsResult result = ReadBounds(
      "# Comment\n"
      "contact/zoo/a ode separation_error=3.1e-05 answering=timed_out\r\n"
      "\n"
      "world/a/b\tmine%20own energy_drift:conserves_energy=0.4 # comment\n",
      "known.bounds");
  ASSERT_THAT(result.diagnostics, IsEmpty());
  const LedgerBounds& bounds = *result.bounds;
  ASSERT_EQ(bounds.size(), 3U);
  const LedgerBound& number =
      bounds.at({"contact/zoo/a", "ode", MeasureKind::kSeparationError, ""});
  EXPECT_EQ(number.verdict, Verdict::kFail);
  EXPECT_EQ(number.value, 3.1e-5);
  EXPECT_EQ(number.line, 2);
  EXPECT_EQ(bounds.at({"contact/zoo/a", "ode", MeasureKind::kAnswering, ""}).verdict,
            Verdict::kTimedOut);
  EXPECT_EQ(
      bounds.at({"world/a/b", "mine own", MeasureKind::kEnergyDrift, "conserves_energy"})
          .value,
      0.4);
}

TEST(ReadBounds, AcceptsATouchingSceneThatIsMissedByNothing) {
  EXPECT_THAT(Complaints("contact/a ode touching=0\n"), IsEmpty());
}

TEST(ReadBounds, RefusesABoundThatBoundsNothing) {
  for (const std::string_view bound :
       {"excess=0", "excess=-1", "excess=nan", "excess=inf", "excess=", "excess=1e",
        "excess=much", "patch_coverage=1.3", "contact_count=1.5"}) {
    EXPECT_THAT(Complaints(fmt::format("contact/a ode {}\n", bound)),
                ElementsAre(StartsWith(fmt::format(
                    "known.bounds:1:15: bound is \"{}\"; expected a ", bound))));
  }
}

TEST(ReadBounds, RefusesWhatItDoesNotKnowWithItsPlace) {
  EXPECT_THAT(
      Complaints("contact/a ode depth=1\ncontact/a ode excess\n"),
      ElementsAre(
          "known.bounds:1:15: bound is \"depth=1\"; expected a measure, \"=\" and "
          "a number or a verdict, e.g. excess=0.001",
          "known.bounds:2:15: bound is \"excess\"; expected a measure, \"=\" and a "
          "number or a verdict, e.g. excess=0.001"));
  EXPECT_THAT(Complaints("contact/a ode\n"),
              ElementsAre("known.bounds:1:11: the line ends too soon; expected a "
                          "scenario, an oracle and bounds, e.g. excess=0.001"));
  EXPECT_THAT(Complaints("<<<<<<< ours\n"), testing::SizeIs(1));
  EXPECT_THAT(Complaints("Contact/a ode excess=1\n"),
              ElementsAre(StartsWith("known.bounds:1:1: scenario is \"Contact/a\"")));
  EXPECT_THAT(Complaints("contact/a o%2 excess=1\n"),
              ElementsAre(StartsWith("known.bounds:1:11: oracle is \"o%2\"")));
}

TEST(ReadBounds, RefusesACellBoundedTwice) {
  EXPECT_THAT(
      Complaints("contact/a ode excess=1\ncontact/a ode swap=1 excess=2\n"),
      ElementsAre("known.bounds:2:22: excess is bounded twice; expected one bound"));
}

TEST(WriteBounds, ReadsBackTheSameAndSorts) {
  LedgerBounds bounds;
  bounds[{"world/b", "ode", MeasureKind::kEnergyDrift, "rolls"}] = {Verdict::kFail, 12,
                                                                    0};
  bounds[{"contact/a", "100 % mine#1", MeasureKind::kExcess, ""}] = {Verdict::kFail,
                                                                     4.1e-10, 0};
  bounds[{"contact/a", "ode", MeasureKind::kAnswering, ""}] = {Verdict::kCrashed, 0, 0};
  bounds[{"contact/a", "ode", MeasureKind::kExcess, ""}] = {Verdict::kFail, 0.00027, 0};
  const std::string text = WriteBounds(bounds, "mine.toml");
  EXPECT_EQ(text.substr(text.find("contact")),
            "contact/a 100%20%25%20mine%231 excess=4.1e-10\n"
            "contact/a ode excess=0.00027 answering=crashed\n"
            "world/b ode energy_drift:rolls=12\n");
  const LedgerBounds again = ReadBounds(text, "mine.bounds").bounds.value();
  ASSERT_EQ(again.size(), bounds.size());
  for (const auto& [cell, bound] : bounds) {
    EXPECT_EQ(again.at(cell).value, bound.value);
    EXPECT_EQ(again.at(cell).verdict, bound.verdict);
  }
  EXPECT_EQ(WriteBounds(again, "mine.toml"), text);
}

TEST(BoundsFile, LiesNextToItsLedger) {
  EXPECT_EQ(BoundsFileOf("a/known_discrepancies.toml"), "a/known_discrepancies.bounds");
  EXPECT_THAT(ReadBoundsFile("nowhere/known.bounds").bounds.value(), IsEmpty());
}

}  // namespace
}  // namespace touchstone
