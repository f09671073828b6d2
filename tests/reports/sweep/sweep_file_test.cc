#include "reports/sweep/sweep_file.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "reports/sweep/merge.h"
#include "reports/sweep/sweep.h"
#include "tests/reports/sweep/bytes_of.h"
#include "tests/reports/sweep/spheres.h"

namespace touchstone {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

class SweepFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("sweep_file_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    // The last block of each series is smaller.
    for (const Family family : {Family::kRandom, Family::kDeep}) {
      plan_.series.emplace_back(QuestionSeries{.family = family,
                                               .A = ShapeKind::kSphere,
                                               .B = ShapeKind::kSphere,
                                               .seed = 3,
                                               .first = 7,
                                               .count = 12 * kContactBlock + 10});
    }
    plan_.subjects = {right_.get(), half_.get()};
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Path(const std::string& name) const { return folder_ / name; }

  /** Sweeps into `name`, as often as that takes, and writes the canonical file. */
  std::string Swept(const std::string& name, const SweepOptions& options) const {
    {
      SweepFile file = SweepFile::Resume(Path(name + ".unfinished"), SettingsOf(plan_));
      EXPECT_TRUE(Sweep(plan_, file, options));
      WritePart(file, Path(name));
    }
    return BytesOf(Path(name));
  }

  /** Returns the message of the SweepFileError of `work`. */
  static std::string ErrorOf(const std::function<void()>& work) {
    try {
      work();
    } catch (const SweepFileError& error) {
      return error.what();
    }
    return "";
  }

  std::string MergeError(const std::vector<std::string>& names) const {
    return ErrorOf([&] {
      std::vector<SweepFile> parts;
      parts.reserve(names.size());
      for (const std::string& name : names) parts.push_back(SweepFile::Open(Path(name)));
      WriteMerged(parts, Path("merged"));
    });
  }

  std::filesystem::path folder_;
  std::unique_ptr<Oracle> right_ = Spheres("right", 1);
  std::unique_ptr<Oracle> half_ = Spheres("half", 0.5);
  SweepPlan plan_;
};

TEST_F(SweepFileTest, ReadsWhatItHasWritten) {
  Swept("all", {.jobs = 2});
  const SweepFile file = SweepFile::Open(Path("all"));
  EXPECT_FALSE(DifferenceOf(file.settings(), SettingsOf(plan_)));
  SeriesTally sum;
  RunBlocks({.series = {plan_.series[0]}, .subjects = plan_.subjects}, {},
            [&sum](std::uint64_t, const SeriesTally& tally) { Merge(tally, sum); });
  EXPECT_EQ(sum.oracles[0].asked, CountOf(plan_.series[0]));
  EXPECT_TRUE(file.Read(0) == sum);
  EXPECT_EQ(FailureCount(sum.oracles[0]), 0U);
  // So the tests of equal bytes are about causes that were not sought, too.
  const auto& answers = sum.oracles[1].answers;
  EXPECT_TRUE(std::any_of(answers.begin(), answers.end(), [](const auto& of_kind) {
    return of_kind.first.cause == Cause::kNotExamined;
  }));
  // Half of the depth is wrong wherever the spheres overlap, unless by a rounding.
  EXPECT_GT(FailureCount(sum.oracles[1]), sum.oracles[1].touching * 99 / 100);
  EXPECT_LE(FailureCount(sum.oracles[1]), sum.oracles[1].touching);
}

TEST_F(SweepFileTest, HasTheSameBytesForAnyNumberOfThreads) {
  const std::string one = Swept("one", {.jobs = 1});
  EXPECT_GT(one.size(), 4096U);
  EXPECT_EQ(one, Swept("three", {.jobs = 3, .commit_after = milliseconds(0)}));
}

TEST_F(SweepFileTest, MergesShardsToTheBytesOfTheWhole) {
  const std::string whole = Swept("whole", {});
  std::vector<SweepFile> parts;
  for (const auto shard : {2U, 0U, 1U}) {
    const std::string name = "part" + std::to_string(shard);
    Swept(name, {.jobs = 2, .shard = {shard, 3}});
    parts.push_back(SweepFile::Open(Path(name)));
  }
  WriteMerged(parts, Path("merged"));
  EXPECT_TRUE(BytesOf(Path("merged")) == whole);
}

// Each child is killed in the middle of a block, somewhere after its first commit.
TEST_F(SweepFileTest, GoesOnAfterBeingKilledAndEndsWithTheSameBytes) {
  const std::string whole = Swept("whole", {});
  int kills = 0;
  for (std::size_t asked = 1000; asked < 60000; asked += 9000) {
    const pid_t child = fork();
    if (child == 0) {
      std::size_t count = 0;
      const auto killer = MakeOracle<Sphere, Sphere>(
          "right",
          [&](const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
            if (++count > asked) raise(SIGKILL);
            return right_->Answer(ContactQuery{{A, X_WA}, {B, X_WB}});
          });
      plan_.subjects[0] = killer.get();
      SweepFile file = SweepFile::Resume(Path("killed.unfinished"), SettingsOf(plan_));
      Sweep(plan_, file, {.jobs = 1, .commit_after = milliseconds(0)});
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) ++kills;
  }
  EXPECT_GE(kills, 2);
  {
    const SweepFile left = SweepFile::Open(Path("killed.unfinished"));
    EXPECT_GT(left.blocks().size(), 0U);
  }
  EXPECT_TRUE(Swept("killed", {.jobs = 2}) == whole);
}

TEST_F(SweepFileTest, GoesOnAfterBeingStopped) {
  const std::string whole = Swept("whole", {});
  int blocks = -1;  // Progress is told before the first block, too.
  {
    SweepFile file = SweepFile::Resume(Path("half.unfinished"), SettingsOf(plan_));
    EXPECT_FALSE(
        Sweep(plan_, file,
              {.jobs = 1,
               .stop = [&blocks] { return blocks >= 3; },
               .on_progress = [&blocks](std::uint64_t, std::uint64_t) { ++blocks; }}));
    EXPECT_EQ(file.blocks().size(), 3U);
  }
  EXPECT_TRUE(Swept("half", {.jobs = 2}) == whole);
}

// Ctrl-C must not wait until the block in progress is done.
TEST_F(SweepFileTest, DropsTheBlockInWhichItIsStopped) {
  const std::string whole = Swept("whole", {});
  // `stop` is called when a question is generated, asked and judged. So each limit on the
  // calls ends in another part of the first block.
  const auto blocks_after = [&](int most) {
    SweepFile file =
        SweepFile::Create(":memory:", SettingsOf(plan_), SweepJournal::kNone);
    int calls = 0;
    EXPECT_FALSE(Sweep(plan_, file, {.jobs = 1, .stop = [&] { return ++calls > most; }}));
    // Only the loops in progress still call it.
    EXPECT_LT(calls, most + 8 * static_cast<int>(kContactBlock));
    return file.blocks().size();
  };
  EXPECT_EQ(blocks_after(100), 0U);
  EXPECT_EQ(blocks_after(400), 0U);
  EXPECT_EQ(blocks_after(1000), 0U);
  {
    int calls = 0;
    SweepFile file = SweepFile::Resume(Path("half.unfinished"), SettingsOf(plan_));
    EXPECT_FALSE(
        Sweep(plan_, file, {.jobs = 1, .stop = [&] { return ++calls > 20000; }}));
    EXPECT_GT(file.blocks().size(), 0U);
  }
  EXPECT_TRUE(Swept("half", {.jobs = 2}) == whole);
}

TEST_F(SweepFileTest, StartsOverFromAFileWithoutTables) {
  const std::string whole = Swept("whole", {});
  std::ofstream(Path("empty.unfinished")).close();
  EXPECT_TRUE(Swept("empty", {}) == whole);
}

TEST_F(SweepFileTest, RefusesTheFileOfAnotherSweep) {
  Swept("some", {});
  std::get<QuestionSeries>(plan_.series[1]).seed = 4;
  const auto resume = [&] {
    SweepFile::Resume(Path("some.unfinished"), SettingsOf(plan_));
  };
  EXPECT_THAT(ErrorOf(resume), HasSubstr("another sweep: seed 3, not 4; expected"));
  std::get<QuestionSeries>(plan_.series[1]).seed = 3;
  plan_.subjects.pop_back();
  EXPECT_THAT(ErrorOf(resume), HasSubstr("another sweep: subjects "));
  plan_.subjects.push_back(half_.get());
  plan_.series.pop_back();
  EXPECT_THAT(ErrorOf(resume), HasSubstr("another sweep: other series"));
}

TEST_F(SweepFileTest, RefusesToMergeOtherThanAllShardsOfOneSweep) {
  for (const auto shard : {0U, 1U})
    Swept("part" + std::to_string(shard), {.shard = {shard, 2}});
  EXPECT_EQ(MergeError({"part0", "part1"}), "");
  EXPECT_THAT(MergeError({"part1"}), HasSubstr("block 0 of 26 is missing; expected"));
  EXPECT_THAT(MergeError({"part0"}), HasSubstr("block 1 of 26 is missing; expected"));
  EXPECT_THAT(MergeError({"part0", "part1", "part0"}),
              HasSubstr("is in another file too; expected each shard once"));
  std::get<QuestionSeries>(plan_.series[0]).seed = 5;
  Swept("other", {.shard = {1, 2}});
  EXPECT_THAT(MergeError({"part0", "other"}),
              HasSubstr("it has seed 5, not 3; expected the settings of"));
  EXPECT_THAT(MergeError({"part0", "absent"}), HasSubstr("absent: does not exist"));
}

TEST_F(SweepFileTest, RefusesForeignAndDamagedFiles) {
  const std::string whole = Swept("whole", {});
  const auto error_of = [this](const std::string& bytes) {
    std::ofstream(Path("damaged"), std::ios::binary) << bytes;
    std::string error = ErrorOf([this] {
      const SweepFile file = SweepFile::Open(Path("damaged"));
      file.Read(0);
    });
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_EQ(error.find(Path("damaged").string()), 0U) << error;
    return error;
  };
  EXPECT_THAT(error_of("no database, but a text that is longer than a header, "
                       "which has a hundred bytes, and then some more bytes"),
              HasSubstr("not the file of a sweep"));
  EXPECT_THAT(error_of(""), HasSubstr("not the file of a sweep"));
  for (const auto part : {2U, 3U, 10U}) {
    EXPECT_THAT(error_of(whole.substr(0, whole.size() * (part - 1) / part)),
                HasSubstr("damaged"));
  }
  std::string version = whole;
  version[63] = 9;  // The last byte of the user version in SQLite's header.
  EXPECT_THAT(error_of(version), HasSubstr("tables of version 9; expected version 6"));
}

TEST_F(SweepFileTest, RefusesAFileThatAnotherSweepWrites) {
  const SweepFile file = SweepFile::Resume(Path("busy"), SettingsOf(plan_));
  const pid_t child = fork();
  if (child == 0) {
    const std::string error =
        ErrorOf([this] { SweepFile::Resume(Path("busy"), SettingsOf(plan_)); });
    _exit(error.find("another process has the file open") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace touchstone
