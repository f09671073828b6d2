#include <atomic>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oracles/isolation/isolated_oracle.h"
#include "oracles/oracle.h"
#include "oracles/simulation.h"
#include "reports/sweep/merge.h"
#include "reports/sweep/sweep.h"
#include "scenarios/scenario_file.h"
#include "tests/reports/sweep/bytes_of.h"
#include "tests/reports/sweep/faller.h"

namespace touchstone {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/** An engine that answers no worlds. */
class Silent final : public Oracle {
 public:
  Silent() { info_.name = "silent"; }
  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}

 private:
  OracleInfo info_;
};

class SweepWorldsTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("sweep_worlds_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    for (const WorldFamily family : {WorldFamily::kDrops, WorldFamily::kRods}) {
      plan_.series.emplace_back(
          WorldSeries{.family = family, .seed = 3, .first = 7, .count = 60});
    }
    plan_.subjects = {&faller_, &silent_};
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Path(const std::string& name) const { return folder_ / name; }

  std::string Swept(const std::string& name, const SweepOptions& options) const {
    {
      SweepFile file = SweepFile::Resume(Path(name + ".unfinished"), SettingsOf(plan_));
      EXPECT_TRUE(Sweep(plan_, file, options));
      WritePart(file, Path(name));
    }
    return BytesOf(Path(name));
  }

  std::filesystem::path folder_;
  Faller faller_;
  Silent silent_;
  SweepPlan plan_;
};

TEST_F(SweepWorldsTest, ReadsWhatItHasWritten) {
  Swept("all", {.jobs = 2});
  const SweepFile file = SweepFile::Open(Path("all"));
  EXPECT_FALSE(DifferenceOf(file.settings(), SettingsOf(plan_)));
  EXPECT_TRUE(IsOfWorlds(file.settings().series[1]));
  SeriesTally sum;
  RunBlocks({.series = {plan_.series[0]}, .subjects = plan_.subjects}, {},
            [&sum](std::uint64_t, const SeriesTally& tally) { Merge(tally, sum); });
  EXPECT_TRUE(file.Read(0) == sum);
  EXPECT_EQ(sum.oracles[0].asked, 60U);
  EXPECT_EQ(sum.oracles[0].verified, 60U);
}

// A body that falls through the ground or off its rod fails. An oracle that simulates
// nothing fails nothing.
TEST_F(SweepWorldsTest, JudgesMotionsByLaws) {
  Swept("all", {});
  const SweepFile file = SweepFile::Open(Path("all"));
  const SeriesTally drops = file.Read(0);
  const SeriesTally rods = file.Read(1);
  EXPECT_GT(FailureCount(drops.oracles[0]), 30U);
  EXPECT_EQ(FailureCount(rods.oracles[0]), 60U);
  EXPECT_TRUE(rods.oracles[0].worst.contains({MeasureKind::kJointError, "joint_length"}));
  EXPECT_EQ(rods.oracles[1].asked, 60U);
  EXPECT_EQ(rods.oracles[1].verified, 0U);
  EXPECT_EQ(FailureCount(rods.oracles[1]), 0U);
}

TEST_F(SweepWorldsTest, KeepsFailuresAsFilesOfTheSameWorld) {
  Swept("all", {});
  const SeriesTally rods = SweepFile::Open(Path("all")).Read(1);
  const FailedQuestion* const gravest = GravestFailure(rods.oracles[0]);
  ASSERT_NE(gravest, nullptr);
  const ReadResult read = ReadScenario(gravest->scenario, "kept");
  ASSERT_TRUE(read.world);
  EXPECT_EQ(
      WriteScenario(*read.world),
      WriteScenario(WorldAt(std::get<WorldSeries>(plan_.series[1]), gravest->question)));
  EXPECT_THAT(
      read.world->source,
      HasSubstr(fmt::format("touchstone sweep world --family rods --seed 3 --first {}",
                            gravest->question)));
}

TEST_F(SweepWorldsTest, HasTheSameBytesForAnyThreadsShardsAndKills) {
  const std::string whole = Swept("whole", {.jobs = 1});
  EXPECT_TRUE(Swept("three", {.jobs = 3, .commit_after = milliseconds(0)}) == whole);
  std::vector<SweepFile> parts;
  for (const auto shard : {2U, 0U, 1U}) {
    const std::string name = "part" + std::to_string(shard);
    Swept(name, {.jobs = 2, .shard = {shard, 3}});
    parts.push_back(SweepFile::Open(Path(name)));
  }
  WriteMerged(parts, Path("merged"));
  EXPECT_TRUE(BytesOf(Path("merged")) == whole);
  // Each child is killed in the middle of a block, somewhere after its first commit.
  int kills = 0;
  for (const int asked : {60, 100, 140}) {
    const pid_t child = fork();
    if (child == 0) {
      const Faller killer(asked, [] { raise(SIGKILL); });
      plan_.subjects[0] = &killer;
      SweepFile file = SweepFile::Resume(Path("killed.unfinished"), SettingsOf(plan_));
      Sweep(plan_, file, {.jobs = 1, .commit_after = milliseconds(0)});
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) ++kills;
  }
  EXPECT_GE(kills, 2);
  EXPECT_GT(SweepFile::Open(Path("killed.unfinished")).blocks().size(), 0U);
  EXPECT_TRUE(Swept("killed", {.jobs = 2}) == whole);
}

// A crash of an isolated engine is one failed world; the others of its block are judged.
TEST_F(SweepWorldsTest, CountsACrashAndGoesOn) {
  const std::unique_ptr<Oracle> crasher = Isolate(
      std::make_unique<Faller>(5, [] { std::abort(); }), {}, IsolationScope::kWorlds);
  const WorldSeries series{.family = WorldFamily::kDrops, .seed = 3, .count = 8};
  const SweepPlan plan{.series = {series}, .subjects = {crasher.get()}};
  SeriesTally sum;
  RunBlocks(plan, {}, [&sum](std::uint64_t, const SeriesTally& t) { Merge(t, sum); });
  std::uint64_t crashed = 0;
  for (const auto& [kind, count] : sum.oracles[0].answers)
    if (kind.verdict == Verdict::kCrashed) crashed += count;
  EXPECT_EQ(crashed, 1U);
  EXPECT_EQ(sum.oracles[0].verified, 7U);
  EXPECT_EQ(sum.oracles[0].asked, 8U);
}

}  // namespace
}  // namespace touchstone
