#include "reports/sweep/file_series.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "reports/sweep/merge.h"
#include "reports/sweep/question_id.h"
#include "reports/sweep/read_file_series.h"
#include "reports/sweep/sweep.h"
#include "reports/sweep/sweep_page.h"
#include "scenarios/scenario_file.h"
#include "scenarios/validate_scenario.h"
#include "tests/reports/sweep/bytes_of.h"
#include "tests/reports/sweep/spheres.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

class FileSeriesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("file_series_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  /** Writes a table of pairs of unit balls, each deeper than the one before, the first of
   which are `step` apart. */
  std::string WriteBalls(int count, double step) const {
    std::ofstream out(Path("balls.csv"));
    out << "A.shape,A.radius,B.shape,B.radius,B.position.x,B.position.y,B.position.z\n";
    for (int i = 0; i < count; ++i)
      out << "sphere,1,sphere,1," << 2 - step * i << ",0,0\n";
    return Path("balls.csv");
  }

  SweepPlan PlanOf(const std::string& file) const {
    SweepPlan plan;
    for (const FileSeries& series : ReadFileSeries(file).series)
      plan.series.emplace_back(series);
    plan.subjects = {right_.get(), half_.get()};
    return plan;
  }

  std::string Swept(const SweepPlan& plan, const std::string& name,
                    const SweepOptions& options) const {
    {
      SweepFile file = SweepFile::Resume(Path(name + ".unfinished"), SettingsOf(plan));
      EXPECT_TRUE(Sweep(plan, file, options));
      WritePart(file, Path(name));
    }
    return BytesOf(Path(name));
  }

  std::string MergeError(const std::vector<std::string>& names) const {
    std::vector<SweepFile> parts;
    for (const std::string& name : names) parts.push_back(SweepFile::Open(Path(name)));
    try {
      WriteMerged(parts, Path("merged"));
    } catch (const SweepFileError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
  std::unique_ptr<Oracle> right_ = Spheres("right", 1);
  std::unique_ptr<Oracle> half_ = Spheres("half", 0.5);
};

TEST_F(FileSeriesTest, IsOneForEachPairInTheOrderOfTheTable) {
  std::ofstream(Path("My Poses.csv"))
      << "A.shape,A.radius,B.shape,B.radius\n"
         "sphere,1,half_space,\nsphere,1,sphere,2\nsphere,3,half_space,\n"
         "half_space,,sphere,4\n";
  const FileOfQuestions read = ReadFileSeries(Path("My Poses.csv"));
  ASSERT_TRUE(read.errors.empty()) << ToString(read.errors[0]);
  ASSERT_EQ(read.series.size(), 3U);
  const FileSeries& ground = read.series[0];
  EXPECT_EQ(ground.B, ShapeKind::kHalfSpace);
  EXPECT_EQ(ground.count, 2U);
  EXPECT_EQ(read.series[1].B, ShapeKind::kSphere);
  EXPECT_EQ(read.series[2].A, ShapeKind::kHalfSpace);
  const Scenario second = ScenarioAt(ground, 1);
  EXPECT_EQ(std::get<Sphere>(second.contact.A.shape).radius, 3);
  EXPECT_EQ(second.title, "Line 4 of My Poses.csv");
  EXPECT_EQ(second.id, "sweep/from/my_poses_" + ground.digest +
                           "/sphere_half_space/00000000000000000001");
  EXPECT_TRUE(FaultsOf(second).empty());
  EXPECT_FALSE(QuestionOfId(second.id));
  EXPECT_EQ(ReplayOf(ground, 1), "touchstone sweep contact --from '" +
                                     Path("My Poses.csv") +
                                     "' --pair sphere half_space --first 1 --count 1");
}

TEST_F(FileSeriesTest, ReadsScenarioFilesAndLeavesWorldsOut) {
  Scenario scenario = ScenarioAt(QuestionSeries{}, 5);
  std::filesystem::create_directories(folder_ / "mine");
  for (const char* id : {"mine/b", "mine/a"}) {
    scenario.id = id;
    scenario.title = id;
    std::ofstream(Path(std::string(id) + ".toml")) << WriteScenario(scenario);
  }
  WorldScenario world = WorldAt(WorldSeries{}, 0);
  world.id = "mine/world";
  std::ofstream(Path("mine/world.toml")) << WriteScenario(world);
  const FileOfQuestions read = ReadFileSeries(Path("mine"));
  ASSERT_TRUE(read.errors.empty()) << ToString(read.errors[0]);
  ASSERT_EQ(read.series.size(), 1U);
  EXPECT_EQ(read.series[0].count, 2U);
  EXPECT_EQ(ScenarioAt(read.series[0], 0).title, "mine/a");
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_THAT(ToNote(read.notes[0]), HasSubstr("1 world is left out"));
  const FileOfQuestions one = ReadFileSeries(Path("mine/world.toml"));
  ASSERT_EQ(one.errors.size(), 1U);
  EXPECT_THAT(ToString(one.errors[0]),
              HasSubstr("has no contact question; expected a scenario with [contact]"));
  EXPECT_EQ(ReadFileSeries(Path("none.toml")).errors.size(), 1U);
  EXPECT_EQ(ReadFileSeries(Path("none.csv")).errors.size(), 1U);
}

TEST_F(FileSeriesTest, KnowsAFileByItsExtensionInAnyCase) {
  const std::string table = "A.shape,A.radius,B.shape\nsphere,1,half_space\n";
  std::ofstream(Path("POSES.CSV")) << table;
  std::ofstream(Path("poses.txt")) << table;
  const FileOfQuestions upper = ReadFileSeries(Path("POSES.CSV"));
  ASSERT_EQ(upper.series.size(), 1U);
  EXPECT_EQ(upper.series[0].count, 1U);
  const FileOfQuestions unknown = ReadFileSeries(Path("poses.txt"));
  ASSERT_EQ(unknown.errors.size(), 1U);
  EXPECT_EQ(ToString(unknown.errors[0]),
            Path("poses.txt") +
                ": has an unknown extension; expected .csv, .jsonl or "
                ".toml, or a folder of scenario files");
}

TEST(DigestOf, IdentifiesWhatIsAskedWhateverItsName) {
  std::vector<Scenario> questions = {ScenarioAt(QuestionSeries{}, 0),
                                     ScenarioAt(QuestionSeries{}, 1)};
  const std::string digest = DigestOf(questions);
  EXPECT_EQ(digest.size(), 16U);
  questions[0].title = "another";
  EXPECT_EQ(DigestOf(questions), digest);
  std::swap(questions[0], questions[1]);
  EXPECT_NE(DigestOf(questions), digest);
  std::swap(questions[0], questions[1]);
  questions[1].contact.A.X_WB.p_WB.x() += 1e-15;
  EXPECT_NE(DigestOf(questions), digest);
}

TEST_F(FileSeriesTest, GivesTheSameBytesForAnyThreadsAndShards) {
  const SweepPlan plan = PlanOf(WriteBalls(2 * kContactBlock + 10, 0.001));
  const std::string one = Swept(plan, "one", {.jobs = 1});
  EXPECT_TRUE(Swept(plan, "three",
                    {.jobs = 3, .commit_after = std::chrono::milliseconds(0)}) == one);
  Swept(plan, "first", {.shard = {0, 2}});
  Swept(plan, "second", {.shard = {1, 2}});
  EXPECT_EQ(MergeError({"second", "first"}), "");
  EXPECT_TRUE(BytesOf(Path("merged")) == one);
  const SweepFile file = SweepFile::Open(Path("one"));
  EXPECT_FALSE(DifferenceOf(file.settings(), SettingsOf(plan)));
  const SeriesTally tally = file.Read(0);
  EXPECT_EQ(tally.oracles[0].asked, 2 * kContactBlock + 10);
  EXPECT_EQ(FailureCount(tally.oracles[0]), 0U);
  // Half of no depth is right.
  EXPECT_EQ(FailureCount(tally.oracles[1]), 2 * kContactBlock + 9);
}

TEST_F(FileSeriesTest, RefusesToGoOnOrToMergeWithOtherQuestions) {
  const SweepPlan before = PlanOf(WriteBalls(2 * kContactBlock, 0.001));
  Swept(before, "first", {.shard = {0, 2}});
  const SweepPlan after = PlanOf(WriteBalls(2 * kContactBlock, 0.0011));
  Swept(after, "second", {.shard = {1, 2}});
  const std::string difference = "questions in " + Path("balls.csv") + " with digest " +
                                 std::get<FileSeries>(after.series[0]).digest + ", not " +
                                 std::get<FileSeries>(before.series[0]).digest;
  EXPECT_THAT(MergeError({"first", "second"}), HasSubstr("it has " + difference));
  try {
    SweepFile::Resume(Path("second.unfinished"), SettingsOf(before));
    ADD_FAILURE() << "went on with other questions";
  } catch (const SweepFileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("belongs to another sweep: " + difference));
  }
}

TEST_F(FileSeriesTest, HasThePageOfTheWorstFindingsWhileTheFileIsThere) {
  const SweepPlan plan = PlanOf(WriteBalls(40, 0.01));
  Swept(plan, "sweep", {});
  const auto kept = [&] {
    return ReadKeptQuestions(Path("sweep"), {.contacts = 200, .worlds = 0},
                             [&](const std::string& name) -> const Oracle& {
                               return name == "half" ? *half_ : *right_;
                             })
        .questions.contacts;
  };
  const std::vector<Scenario> all = kept();
  EXPECT_TRUE(std::ranges::all_of(all, [](const Scenario& question) {
    return question.id.starts_with("sweep/from/balls_");
  }));
  WriteBalls(40, 0.02);
  const std::size_t failures = kept().size();
  EXPECT_GT(failures, 0U);
  EXPECT_LT(failures, all.size());
}

}  // namespace
}  // namespace touchstone
