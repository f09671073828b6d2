#include "reports/writers/junit_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::string JUnit(const RunReport& report, const FailureRule& rule = {}) {
  std::ostringstream out;
  WriteJUnit(report, rule, out);
  return out.str();
}

TEST(WriteJUnit, CountsFailuresAndSkipsForADashboard) {
  // Six test cases and a fault. Failed: one proved, one invalid, one fault. Skipped: one
  // known, one unsupported.
  EXPECT_THAT(JUnit(HandMadeReport()),
              HasSubstr("<testsuites name=\"touchstone\" tests=\"7\" failures=\"3\" "
                        "errors=\"0\" skipped=\"2\" time=\"0.000000\">"));
}

// A dashboard must not be red where the exit code is 0.
TEST(WriteJUnit, SkipsFailuresThatDoNotCount) {
  EXPECT_THAT(JUnit(HandMadeReport(), {.whose = FailOn::kSubject}),
              HasSubstr("failures=\"2\" errors=\"0\" skipped=\"3\""));
}

TEST(WriteJUnit, SaysHowLongAnAnswerTookAndItsSuite) {
  RunReport report = HandMadeReport();
  report.scenarios[0].answers[1].seconds = 0.25;
  report.scenarios[1].answers[1].seconds = 1;
  EXPECT_THAT(JUnit(report), HasSubstr("classname=\"theirs/float\" "
                                       "name=\"contact/box_sphere/deep\" "
                                       "time=\"0.250000\""));
  EXPECT_THAT(JUnit(report),
              ContainsRegex("testsuite name=\"theirs/float\".* time=\"1.250000\">"));
}

TEST(WriteJUnit, SkipsKnownWithTheReasonOfTheLedger) {
  EXPECT_THAT(JUnit(HandMadeReport()),
              HasSubstr("<skipped type=\"known\" message=\"Float build\"/>"));
}

TEST(WriteJUnit, SkipsUnsupportedWithTheReasonOfTheOracle) {
  EXPECT_THAT(JUnit(HandMadeReport()), HasSubstr("<skipped type=\"unsupported\""));
}

TEST(WriteJUnit, WritesACrashAsAnError) {
  RunReport report = HandMadeReport();
  report.findings[4].verdict = Verdict::kCrashed;
  EXPECT_THAT(JUnit(report), HasSubstr("<error type=\"crashed\""));
}

TEST(WriteJUnit, EscapesMarkupAndControlCharacters) {
  const std::string xml = JUnit(HandMadeReport());
  EXPECT_THAT(xml, HasSubstr("expects &quot;apart&quot;"));
  EXPECT_THAT(xml, Not(HasSubstr("\x01")));
}

}  // namespace
}  // namespace touchstone
