#include "reports/writers/timings_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::string Timings(const RunReport& report) {
  std::ostringstream out;
  WriteTimings(report, out);
  return out.str();
}

/** Adds a world that `seconds` are spent on by the first oracle. */
void AddWorld(const std::string& id, const WorldSeconds& seconds, RunReport& report) {
  for (OracleInfo& oracle : report.oracles) oracle.simulates = true;
  WorldResult& world = report.worlds.emplace_back();
  world.scenario.id = id;
  world.trajectories.resize(report.oracles.size());
  world.seconds.resize(report.oracles.size());
  world.seconds.front() = seconds;
}

TEST(WriteTimings, ListsTheLongestFirst) {
  RunReport report = HandMadeReport();
  AddWorld("world/test/short", {0.5, {}, {}}, report);
  AddWorld("world/test/long", {2.5, {}, {}}, report);
  const std::string text = Timings(report);
  EXPECT_THAT(text, ContainsRegex("2.5000 s  world/test/long  mine\n"));
  EXPECT_LT(text.find("world/test/long"), text.find("world/test/short"));
  EXPECT_LT(text.find("world/test/short"), text.find("contact/box_sphere/deep"));
}

TEST(WriteTimings, ListsTwenty) {
  RunReport report = HandMadeReport();
  for (int i = 0; i < 30; ++i)
    AddWorld("world/test/" + std::to_string(i), {1.0 + i, {}, {}}, report);
  EXPECT_THAT(Timings(report),
              AllOf(HasSubstr("world/test/29  mine"), HasSubstr("world/test/10  mine"),
                    Not(HasSubstr("world/test/9  mine"))));
}

TEST(WriteTimings, SumsByOracleMotionLawAndKindOfQuery) {
  RunReport report = HandMadeReport();
  AddWorld("world/test/a", {3, {{"half step", 1}}, {{"ballistic", 0.25}}}, report);
  AddWorld("world/test/b", {5, {{"half step", 2}, {"mirror", 1}}, {}}, report);
  report.scenarios[0].answers[1].seconds = 2;
  report.seconds_of_contacts = {{"truth", 3}, {"itself", 1}};
  const std::string text = Timings(report);
  EXPECT_THAT(text, ContainsRegex("8.00 s +80 %  mine\n +2.00 s +20 %  theirs/float\n"));
  EXPECT_THAT(text, ContainsRegex("3.00 s +30 %  half step\n +1.00 s +10 %  mirror\n"));
  EXPECT_THAT(text, HasSubstr("0.25 s    2 %  ballistic\n"));
  EXPECT_THAT(text, ContainsRegex("3.00 s +75 %  truth\n +1.00 s +25 %  itself\n"));
}

TEST(WriteTimings, LeavesOutWhatNobodyWaitsFor) {
  RunReport report = HandMadeReport();
  AddWorld("world/test/a", {3, {{"mirror", 0.004}}, {}}, report);
  EXPECT_THAT(Timings(report), Not(HasSubstr("mirror")));
}

}  // namespace
}  // namespace touchstone
