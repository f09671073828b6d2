#include "reports/sweep/sweep_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "reports/run.h"
#include "reports/sweep/sweep.h"
#include "reports/writers/data/data_file.h"
#include "reports/writers/read_report_data.h"
#include "reports/writers/report_data.h"
#include "tests/reports/sweep/faller.h"
#include "tests/reports/sweep/spheres.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

/** Returns the JSON of the data of a sweep's page. */
DataJson DataOfPage(const std::filesystem::path& file,
                    const std::vector<const Oracle*>& oracles, std::size_t most,
                    const Ledger& ledger) {
  const auto oracle_named = [&](const std::string& name) -> const Oracle& {
    return **std::ranges::find_if(
        oracles, [&](const Oracle* oracle) { return oracle->info().name == name; });
  };
  const KeptQuestions kept =
      ReadKeptQuestions(file, {.contacts = most, .worlds = most}, oracle_named);
  const RunReport report = touchstone::Run(kept.questions, oracles, {}, {});
  const std::string data = WithSweep(ReportData(report, {}), file, ledger);
  return UnpackData(data, kMostReportData).file.value().json;
}

/** Returns the name of a cell of a column of `sweep`; "" for none. */
std::string NameAt(const DataJson& sweep, const char* table, const char* column,
                   std::size_t row) {
  const int index = sweep[table][column][row].get<int>();
  return index < 0
             ? ""
             : sweep["names"][column][static_cast<std::size_t>(index)].get<std::string>();
}

/** A sweep over two families of spheres: one oracle states the depth, one half of it. */
class SweepPageTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("sweep_page_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    SweepPlan plan;
    for (const Family family : {Family::kRandom, Family::kVertexFace}) {
      plan.series.emplace_back(QuestionSeries{.family = family,
                                              .A = ShapeKind::kSphere,
                                              .B = ShapeKind::kSphere,
                                              .seed = 3,
                                              .first = 0,
                                              .count = kCount});
    }
    plan.subjects = {right_.get(), half_.get()};
    SweepFile file = SweepFile::Resume(File(), SettingsOf(plan));
    EXPECT_TRUE(Sweep(plan, file, {}));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path File() const { return folder_ / "sweep.sqlite"; }

  /** Returns the JSON of the page's data, with at most `most` questions of failures asked
   again, and as many of the worst findings. */
  DataJson PageData(std::size_t most, const Ledger& ledger = {}) const {
    return DataOfPage(File(), {right_.get(), half_.get()}, most, ledger);
  }

  static constexpr std::uint64_t kCount = 100;
  std::filesystem::path folder_;
  std::unique_ptr<Oracle> right_ = Spheres("right", 1);
  std::unique_ptr<Oracle> half_ = Spheres("half", 0.5);
};

TEST_F(SweepPageTest, CountsEachAnswerOnce) {
  const DataJson sweep = PageData(10)["sweep"];
  EXPECT_EQ(sweep["asked"], 2 * kCount);
  EXPECT_EQ(sweep["names"]["oracle"], DataJson({"right", "half"}));
  std::map<std::string, std::uint64_t> answers;
  std::uint64_t failed = 0;
  for (std::size_t i = 0; i < sweep["answers"]["count"].size(); ++i) {
    const auto name = [&](const char* column) {
      return sweep["names"][column][sweep["answers"][column][i].get<std::size_t>()]
          .get<std::string>();
    };
    const auto count = sweep["answers"]["count"][i].get<std::uint64_t>();
    answers[name("oracle")] += count;
    if (name("verdict") == "fail") {
      EXPECT_EQ(name("oracle"), "half");
      failed += count;
    }
  }
  EXPECT_EQ(answers["right"], 2 * kCount);
  EXPECT_EQ(answers["half"], 2 * kCount);
  EXPECT_GT(failed, 0U);
  EXPECT_EQ(sweep["failed"], failed);
}

// Half of a depth is wrong by the other half, which is of the size of the spheres at
// most.
TEST_F(SweepPageTest, SumsTheSketchesInQuartersOfADecade) {
  const DataJson sweep = PageData(10)["sweep"];
  const DataJson& sketches = sweep["sketches"];
  bool found = false;
  for (std::size_t i = 0; i < sketches["oracle"].size(); ++i) {
    if (sketches["oracle"][i] != 1 ||
        sweep["names"]["measure"][sketches["measure"][i].get<std::size_t>()] !=
            "separation_error")
      continue;
    found = true;
    auto total = sketches["zeros"][i].get<std::uint64_t>();
    const DataJson& bins = sketches["bins"][i];
    for (std::size_t b = 0; b + 1 < bins.size(); b += 2)
      total += bins[b + 1].get<std::uint64_t>();
    EXPECT_GT(total, 0U);
    EXPECT_LE(total, 2 * kCount);
    // The largest error is between 1 cm and 10 m: from bin −8 to bin 4.
    const int largest = bins[bins.size() - 2].get<int>();
    EXPECT_GE(largest, -8);
    EXPECT_LT(largest, 4);
  }
  EXPECT_TRUE(found);
}

TEST_F(SweepPageTest, AsksAFewFailuresOfEachKindAgain) {
  const DataJson data = PageData(200);
  const DataJson& failures = data["sweep"]["failures"];
  ASSERT_GE(failures["question"].size(), 1U);
  double before = HUGE_VAL;
  for (std::size_t i = 0; i < failures["question"].size(); ++i) {
    EXPECT_LE(failures["share"][i].get<double>(), before);
    before = failures["share"][i].get<double>();
    const DataJson& question =
        data["questions"][failures["question"][i].get<std::size_t>()];
    EXPECT_THAT(question["id"].get<std::string>(),
                HasSubstr("sweep/" + NameAt(data["sweep"], "failures", "family", i) +
                          "/sphere_sphere/seed_3/"));
    EXPECT_EQ(NameAt(data["sweep"], "failures", "pair", i), "sphere–sphere");
    // Its id alone asks it.
    EXPECT_FALSE(question.contains("own"));
    // It was asked again: the second oracle is wrong in it, by the same proof.
    const DataJson& answer = question["contact"]["answers"][1];
    EXPECT_EQ(answer["status"], "answered");
    EXPECT_THAT(failures["proof"][i].get<std::string>(), HasSubstr("half says"));
  }
}

// One question of a failure, and one of a worst finding unless it is the same.
TEST_F(SweepPageTest, AsksNoMoreQuestionsThanTheLimits) {
  const std::size_t questions = PageData(1)["questions"].size();
  EXPECT_GE(questions, 1U);
  EXPECT_LE(questions, 2U);
  EXPECT_EQ(PageData(0)["questions"].size(), 0U);
}

TEST_F(SweepPageTest, OpensTheWorstFindingOfEachMeasureAlsoIfItPasses) {
  const DataJson data = PageData(200);
  const DataJson& worst = data["sweep"]["worst"];
  ASSERT_GE(worst["question"].size(), 2U);
  double before = HUGE_VAL;
  std::set<std::string> verdicts_of_right;
  for (std::size_t i = 0; i < worst["question"].size(); ++i) {
    // An infinite multiple is a text: JSON has no number for it.
    const double tolerances = worst["tolerances"][i].is_number()
                                  ? worst["tolerances"][i].get<double>()
                                  : HUGE_VAL;
    EXPECT_LE(tolerances, before);
    before = tolerances;
    const std::string oracle = NameAt(data["sweep"], "worst", "oracle", i);
    if (oracle == "right")
      verdicts_of_right.insert(NameAt(data["sweep"], "worst", "verdict", i));
    // Asked again, it has the same error.
    const auto question = worst["question"][i].get<std::size_t>();
    const std::string measure = NameAt(data["sweep"], "worst", "measure", i);
    bool found = false;
    for (std::size_t f = 0; f < data["findings"]["question"].size(); ++f) {
      const auto column = [&](const char* name) {
        return data["findings"][name][f].get<std::size_t>();
      };
      if (column("question") != question ||
          data["oracles"][column("oracle")]["name"] != oracle ||
          data["names"]["measure"][column("measure")]["name"] != measure)
        continue;
      found = true;
      EXPECT_NEAR(data["findings"]["value"][f].get<double>(),
                  worst["value"][i].get<double>(),
                  1e-3 * worst["value"][i].get<double>());
    }
    EXPECT_TRUE(found) << oracle << ' ' << measure;
  }
  EXPECT_EQ(verdicts_of_right, std::set<std::string>{"pass"});
}

TEST_F(SweepPageTest, CallsAFaultNewUnlessTheLedgerHasAnEntryOfItsKind) {
  const auto new_clusters = [&](const Ledger& ledger) {
    const DataJson data = PageData(10, ledger);
    return static_cast<std::size_t>(std::ranges::count_if(
        data["clusters"],
        [](const DataJson& cluster) { return cluster["is_new"].get<bool>(); }));
  };
  const auto new_failures = [&](const Ledger& ledger) {
    const DataJson data = PageData(10, ledger);
    return std::ranges::count(data["sweep"]["failures"]["is_new"], DataJson(true));
  };
  const DataJson data = PageData(10);
  const std::size_t all = data["clusters"].size();
  ASSERT_GT(all, 0U);
  EXPECT_EQ(new_clusters({}), all);
  EXPECT_GT(new_failures({}), 0);
  LedgerEntry entry;
  entry.scenarios = {"contact/elsewhere/*"};
  entry.oracle = "half";
  entry.version = half_->info().version;
  entry.measures = AllMeasures();
  entry.causes = {Cause::kNone,      Cause::kConvention,     Cause::kTie,
                  Cause::kPrecision, Cause::kDiscretisation, Cause::kModel,
                  Cause::kDefect};
  Ledger ledger;
  ledger.entries = {entry};
  EXPECT_EQ(new_clusters(ledger), 0U);
  EXPECT_EQ(new_failures(ledger), 0);
  ledger.entries[0].version = "another";
  EXPECT_EQ(new_clusters(ledger), all);
}

// A climb is repeated with its oracle, so the ids say which one it was.
TEST_F(SweepPageTest, OpensTheQuestionsOfAWorstCaseSearchOfEachOracle) {
  SweepPlan plan;
  plan.series.emplace_back(QuestionSeries{.family = Family::kRandom,
                                          .A = ShapeKind::kSphere,
                                          .B = ShapeKind::kSphere,
                                          .seed = 5,
                                          .first = 0,
                                          .count = 60,
                                          .climb = 20});
  const std::unique_ptr<Oracle> third = Spheres("third", 1.0 / 3);
  plan.subjects = {third.get(), half_.get()};
  const std::filesystem::path path = folder_ / "climb.sqlite";
  {
    SweepFile file = SweepFile::Resume(path, SettingsOf(plan));
    EXPECT_TRUE(Sweep(plan, file, {}));
  }
  const DataJson data = DataOfPage(path, {third.get(), half_.get()}, 50, {});
  std::set<std::string> oracles;
  const DataJson& worst = data["sweep"]["worst"];
  for (std::size_t i = 0; i < worst["question"].size(); ++i) {
    const std::string oracle = NameAt(data["sweep"], "worst", "oracle", i);
    oracles.insert(oracle);
    EXPECT_EQ(data["questions"][worst["question"][i].get<std::size_t>()]["own"], true);
    EXPECT_THAT(data["questions"][worst["question"][i].get<std::size_t>()]["id"]
                    .get<std::string>(),
                testing::EndsWith("/" + oracle));
  }
  EXPECT_EQ(oracles, (std::set<std::string>{"half", "third"}));
}

TEST_F(SweepPageTest, OpensTheFailuresOfASweepOfWorldsAsWorlds) {
  SweepPlan plan;
  for (const WorldFamily family : {WorldFamily::kDrops, WorldFamily::kRods}) {
    plan.series.emplace_back(
        WorldSeries{.family = family, .seed = 3, .first = 7, .count = 20});
  }
  const Faller faller;
  plan.subjects = {&faller};
  const std::filesystem::path path = folder_ / "worlds.sqlite";
  {
    SweepFile file = SweepFile::Resume(path, SettingsOf(plan));
    EXPECT_TRUE(Sweep(plan, file, {}));
  }
  const DataJson data = DataOfPage(path, {&faller}, 6, {});
  const DataJson& sweep = data["sweep"];
  EXPECT_EQ(sweep["kind"], "world");
  EXPECT_EQ(sweep["asked"], 40);
  EXPECT_EQ(sweep["names"]["family"], DataJson({"drops", "rods"}));
  EXPECT_EQ(sweep["names"]["pair"], DataJson::array());
  ASSERT_GE(sweep["failures"]["question"].size(), 1U);
  std::set<std::string> laws;
  for (std::size_t i = 0; i < sweep["failures"]["question"].size(); ++i) {
    const DataJson& question =
        data["questions"][sweep["failures"]["question"][i].get<std::size_t>()];
    EXPECT_EQ(question["kind"], "world");
    EXPECT_EQ(question["world"]["motions"][0]["status"], "answered");
    EXPECT_EQ(sweep["failures"]["pair"][i], -1);
    laws.insert(NameAt(sweep, "failures", "law", i));
  }
  EXPECT_GE(laws.size(), 2U);
  EXPECT_FALSE(laws.contains(""));
  // Every law of every motion is counted: more findings than motions.
  std::uint64_t findings = 0;
  for (const DataJson& count : sweep["findings"]["count"])
    findings += count.get<std::uint64_t>();
  EXPECT_GT(findings, 40U);
  EXPECT_GE(sweep["worst"]["question"].size(), 1U);
}

TEST_F(SweepPageTest, RefusesAFileThatIsNoSweep) {
  const auto none = [this](const std::string&) -> const Oracle& { return *right_; };
  const std::filesystem::path other = folder_ / "other.sqlite";
  std::ofstream(other) << "no database";
  EXPECT_THROW(ReadKeptQuestions(other, {1, 1}, none), SweepFileError);
  EXPECT_THROW(ReadKeptQuestions(folder_ / "none.sqlite", {1, 1}, none), SweepFileError);
}

}  // namespace
}  // namespace touchstone
