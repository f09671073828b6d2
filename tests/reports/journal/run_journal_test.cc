// Tests of the worlds that a run keeps.

#include "reports/journal/run_journal.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "reports/journal/examination_wire.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

WorldScenario Flight(int steps) {
  WorldScenario scenario;
  scenario.id = "world/test/flight";
  scenario.title = "A ball in flight";
  scenario.source = "Galileo";
  scenario.world.bodies = {BodyOf("ball", Sphere{0.5}, 2, {0.3, 1.7, -0.4})};
  scenario.world.steps = steps;
  scenario.claims = {ClaimOf("ballistic")};
  return scenario;
}

Trajectory Exact(const World& world) {
  return FreeFlight(world);
}

/** Returns a result with a value of its own in every field. */
Examination SomeResult() {
  Examination result;
  result.trajectory = FreeFlight(Flight(7).world);
  result.trajectory.complaint = "LCP internal error";
  result.drifts = {0.1, 1.0 / 3, 1e-300, -0.0};
  result.ensemble = {5, {1, 2}, {3, 4}, {5, 6}};
  Finding finding;
  finding.scenario = "world/test/flight";
  finding.oracle = "a";
  finding.reference = "law";
  finding.law = "ballistic";
  finding.universal = true;
  finding.measure = MeasureKind::kPositionError;
  finding.value = 0.7;
  finding.tolerance = 1e-17;
  finding.tolerance_because = "64 roundings";
  finding.verdict = Verdict::kFail;
  finding.undecided = Undecided::kCoarse;
  finding.grade = Grade::kGross;
  finding.safety = 1.5;
  finding.cause = Cause::kDefect;
  finding.cause_because = "of none of these";
  finding.shipped = Shipped::kHereOnly;
  finding.shipped_because = "with the default it passes";
  finding.proof = std::string("with a \0 in it", 14);
  finding.cited = {{"ball", ""}, 0.25, {{0.1, -0.0, 1e-300}, {1, 2, 3}}, 0.125};
  finding.ledger_entry = 3;
  result.findings = {Finding{}, finding};
  result.seconds = {1.5, {{"itself", 0.5}, {"mirror", 0.25}}, {{"ballistic", 0.125}}};
  return result;
}

TEST(ExaminationWire, CarriesEveryFieldBitForBit) {
  const std::string bytes = ToWire(SomeResult());
  const std::optional<Examination> received = ExaminationFromWire(bytes);
  ASSERT_TRUE(received);
  EXPECT_EQ(ToWire(*received), bytes);
  const Finding& finding = received->findings.at(1);
  EXPECT_EQ(finding.proof, SomeResult().findings[1].proof);
  EXPECT_EQ(finding.shipped, Shipped::kHereOnly);
  EXPECT_EQ(finding.cited, SomeResult().findings[1].cited);
  EXPECT_EQ(received->findings.at(0).cited, Cited());
  EXPECT_EQ(finding.ledger_entry, 3);
  EXPECT_FALSE(received->findings.at(0).ledger_entry);
  EXPECT_EQ(received->ensemble.width.deviation, 6);
  EXPECT_TRUE(std::signbit(received->drifts.angular_momentum));
  EXPECT_EQ(received->trajectory.complaint, "LCP internal error");
  EXPECT_EQ(received->seconds.all, 1.5);
  EXPECT_EQ(received->seconds.motions, SomeResult().seconds.motions);
  EXPECT_EQ(received->seconds.laws, SomeResult().seconds.laws);
}

TEST(ExaminationWire, IsRefusedIfItIsCutOrContinued) {
  const std::string bytes = ToWire(SomeResult());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(ExaminationFromWire(std::string_view(bytes).substr(0, size))) << size;
  EXPECT_FALSE(ExaminationFromWire(bytes + '\0'));
}

class RunJournalTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("run_journal_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path File() const { return folder_ / "run.unfinished.sqlite"; }

  std::filesystem::path folder_;
  FakeSimulator oracle_{"a", Exact};
};

TEST_F(RunJournalTest, FindsWhatItKeptAfterItWasOpenedAgain) {
  RunJournal(File(), "build 1").Keep(Flight(7), oracle_.info(), SomeResult());
  const RunJournal again(File(), "build 1");
  EXPECT_EQ(again.size(), 1);
  const std::optional<Examination> found = again.Find(Flight(7), oracle_.info());
  ASSERT_TRUE(found);
  EXPECT_EQ(ToWire(*found), ToWire(SomeResult()));
}

TEST_F(RunJournalTest, TakesNoResultForAnother) {
  RunJournal journal(File(), "build 1");
  journal.Keep(Flight(7), oracle_.info(), SomeResult());
  EXPECT_FALSE(journal.Find(Flight(8), oracle_.info()));
  WorldScenario edited = Flight(7);
  edited.world.bodies[0].mass *= 1 + 1e-15;
  EXPECT_FALSE(journal.Find(edited, oracle_.info()));
  OracleInfo newer = oracle_.info();
  newer.version += "1";
  EXPECT_FALSE(journal.Find(Flight(7), newer));
  OracleInfo set_otherwise = oracle_.info();
  set_otherwise.settings.push_back({"iterations", "10", ""});
  EXPECT_FALSE(journal.Find(Flight(7), set_otherwise));
}

TEST_F(RunJournalTest, ForgetsTheResultsOfAnotherBuild) {
  RunJournal(File(), "build 1").Keep(Flight(7), oracle_.info(), SomeResult());
  EXPECT_EQ(RunJournal(File(), "build 2").size(), 0);
}

TEST_F(RunJournalTest, LeavesNoFileOnceItIsRemoved) {
  RunJournal journal(File(), "build 1");
  journal.Keep(Flight(7), oracle_.info(), SomeResult());
  journal.Remove();
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(RunJournalTest, HasEveryResultThatWasKeptBeforeAKill) {
  const pid_t child = fork();
  if (child == 0) {
    RunJournal journal(File(), "build 1");
    for (int steps = 1; steps <= 5; ++steps)
      journal.Keep(Flight(steps), oracle_.info(), SomeResult());
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(RunJournal(File(), "build 1").size(), 5);
}

TEST_F(RunJournalTest, RefusesAFileThatIsNoDatabase) {
  std::ofstream(File()) << "not a database, but long enough to be read as one ......";
  EXPECT_THROW(RunJournal(File(), "build 1"), SweepFileError);
}

}  // namespace
}  // namespace touchstone
