#include "reports/writers/report_data.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"
#include "reports/writers/comparison_writer.h"
#include "reports/writers/data/data_file.h"
#include "reports/writers/data/deflate.h"
#include "reports/writers/data/track.h"
#include "reports/writers/read_report_data.h"

namespace touchstone {
namespace {

using ::testing::HasSubstr;

const RunFacts kFacts{.program = "touchstone 1", .command = "touchstone run mine"};

DataJson JsonOf(const RunReport& report) {
  return UnpackData(ReportData(report, kFacts), kMostReportData).file.value().json;
}

/** Reads a track as docs/report_data.md says. */
std::vector<std::vector<double>> Read(const DataJson& track, const std::string& blob) {
  std::size_t at = track["at"].get<std::size_t>();
  std::vector<std::vector<double>> channels;
  for (const DataJson& scale : track["scale"]) {
    channels.emplace_back();
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < track["samples"].get<std::size_t>(); ++i) {
      std::uint64_t zigzag = 0;
      for (int shift = 0;; shift += 7) {
        const auto byte = static_cast<unsigned char>(blob.at(at++));
        zigzag |= std::uint64_t{byte & 0x7fU} << shift;
        if (byte < 0x80) break;
      }
      sum +=
          static_cast<std::int64_t>(zigzag >> 1) ^ -static_cast<std::int64_t>(zigzag & 1);
      channels.back().push_back(static_cast<double>(sum) * scale.get<double>());
    }
  }
  return channels;
}

TEST(AddTrack, KeepsEveryValueToHalfAStep) {
  std::string blob = "before";
  const std::vector<double> falling = {1, 0.95, 0.8, -3.25, 1e6, 0};
  const std::vector<double> tiny = {0, 1e-9, -1e-9, 2e-9, 0, 5e-9};
  const DataJson track = AddTrack({{falling, 1e-3}, {tiny, 1e-10}}, blob);
  const auto read = Read(track, blob);
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < falling.size(); ++i) {
    EXPECT_NEAR(read[0][i], falling[i], 0.51e-3);
    EXPECT_NEAR(read[1][i], tiny[i], 0.51e-10);
  }
}

// A body that slides by 30 steps of the common rounding would move in visible jumps.
TEST(SmoothStep, IsAFourHundredthOfWhatMovesAndTheCommonStepOfWhatStays) {
  EXPECT_EQ(SmoothStep({0, 30, 12, NAN}, 1, 0.01), 30.0 / 400);
  EXPECT_EQ(SmoothStep({5, 6.9, 5}, 1, 0.01), 1);
  EXPECT_EQ(SmoothStep({0, 3}, 1, 0.01), 0.01);
  EXPECT_EQ(SmoothStep({0, 4000}, 1, 0.01), 1);
  EXPECT_EQ(SmoothStep({}, 1, 0.01), 1);
}

TEST(AddTrack, WidensAStepThatDoublesOfABrowserCannotCount) {
  std::string blob;
  const DataJson track = AddTrack({{{1e12, -1e12, NAN}, 1e-9}}, blob);
  const double step = track["scale"][0].get<double>();
  EXPECT_LE(2e12 / step, 0x1p53);
  EXPECT_NEAR(Read(track, blob)[0][1], -1e12, step);
  EXPECT_NEAR(Read(track, blob)[0][2], -1e12, step);  // Not a number: as before.
}

TEST(Inflated, RefusesWhatIsCutOffFollowedOrTooLarge) {
  const std::string text(100'000, 'a');
  const std::string deflated = Deflated(text);
  EXPECT_LT(deflated.size(), 1000U);
  EXPECT_EQ(Inflated(deflated, text.size()), text);
  EXPECT_FALSE(Inflated(deflated, text.size() - 1));
  EXPECT_FALSE(Inflated(deflated.substr(0, deflated.size() - 1), text.size()));
  EXPECT_FALSE(Inflated(deflated + "x", text.size()));
  EXPECT_FALSE(Inflated("", text.size()));
  EXPECT_FALSE(Inflated("not deflated", text.size()));
}

TEST(ReportData, HoldsQuestionsAnswersAndFindings) {
  const DataJson data = JsonOf(HandMadeReport());
  EXPECT_EQ(data["format"], "touchstone report data");
  EXPECT_EQ(data["sentence"], "2 oracles answered 3 contact questions.");
  EXPECT_THAT(data["conclusion"].get<std::string>(), HasSubstr("FAILED: mine failed in"));
  EXPECT_EQ(data["exit_code"], 1);
  ASSERT_EQ(data["questions"].size(), 3U);
  const DataJson& question = data["questions"][0];
  EXPECT_EQ(question["title"], "A sphere in a <box> & out again");
  EXPECT_EQ(question["size"], 0.5);  // The diameter of the sphere; the box is larger.
  EXPECT_EQ(question["pair"], "box–sphere");
  EXPECT_EQ(question["contact"]["A"]["shape"]["half"], DataJson({0.3, 0.2, 0.1}));
  EXPECT_EQ(question["contact"]["truth"]["lo"], -0.05);
  EXPECT_EQ(data["questions"][2]["contact"]["answers"][1]["status"], "unsupported");
  EXPECT_EQ(data["questions"][1]["contact"]["answers"][1]["separation"], "nan");
  const DataJson& findings = data["findings"];
  for (const auto& [name, column] : findings.items())
    EXPECT_EQ(column.size(), 7U) << name;
  EXPECT_EQ(findings["value"][2], 0.01);
  EXPECT_EQ(findings["share"][2], 0.02);  // 1 cm of 50 cm.
  EXPECT_EQ(data["texts"][findings["proof"][2].get<std::size_t>()],
            "mine says 0.04 deep; moving B by 0.04 along n leaves 0.01 of overlap");
  EXPECT_EQ(findings["value"][4], "nan");
}

TEST(ReportData, SaysHowLongEachAnswerTook) {
  RunReport report = HandMadeReport();
  report.scenarios[1].answers[0].seconds = 0.012345;
  report.seconds_of_contacts = {{"truth", 1.5}};
  report.oracles.emplace_back().name = "worlds only";
  for (ScenarioResult& result : report.scenarios) result.answers.emplace_back();
  const DataJson data = JsonOf(report);
  ASSERT_EQ(data["seconds"].size(), report.scenarios.size());
  EXPECT_EQ(data["seconds"][1], DataJson({0.0123, 0.0, nullptr}));
  EXPECT_EQ(data["spent"]["contacts"]["truth"], 1.5);
}

TEST(ReportData, RanksClustersAndRefersToThem) {
  const DataJson data = JsonOf(HandMadeReport());
  const DataJson& clusters = data["clusters"];
  // Invalid numbers, two measures of "mine", and a reason of the ledger.
  ASSERT_EQ(clusters.size(), 4U);
  EXPECT_EQ(data["names"]["grade"][clusters[0]["grade"].get<std::size_t>()], "unusable");
  EXPECT_EQ(data["findings"]["cluster"][4], 0);
  EXPECT_EQ(data["findings"]["cluster"][0], -1);
  EXPECT_EQ(clusters[0]["title"], "theirs/float gives an invalid answer.");
  EXPECT_EQ(clusters[0]["extent"], "In 1 scenario.");
  EXPECT_EQ(clusters[0]["counts"], true);
  EXPECT_EQ(clusters[3]["counts"], false);  // The ledger knows it.
  EXPECT_EQ(data["ledger"][0]["fault"], "Float build.");
}

TEST(ReportData, SaysWhichQuestionsOnlyTheirFilesAsk) {
  const RunFacts facts{.program = "touchstone 1",
                       .command = "touchstone run mine",
                       .own = {"contact/box_sphere/wrong"}};
  const DataJson data =
      UnpackData(ReportData(HandMadeReport(), facts), kMostReportData).file.value().json;
  std::vector<std::string> own;
  for (const DataJson& question : data["questions"]) {
    if (question.contains("own")) own.push_back(question["id"].get<std::string>());
  }
  EXPECT_EQ(own, std::vector<std::string>{"contact/box_sphere/wrong"});
}

TEST(ReportData, IsTheSameForTheSameReport) {
  EXPECT_EQ(ReportData(HandMadeReport(), kFacts), ReportData(HandMadeReport(), kFacts));
}

TEST(ReportData, ReplacesTextThatIsNotUtf8) {
  RunReport report = HandMadeReport();
  report.scenarios[2].answers[1].reason = "\xff";
  EXPECT_EQ(JsonOf(report)["questions"][2]["contact"]["answers"][1]["reason"], "\ufffd");
}

TEST(ReadReport, ReadsTheFindings) {
  const ReadReportResult result =
      ReadReport(ReportData(HandMadeReport(), kFacts), "r.data");
  ASSERT_TRUE(result.data);
  EXPECT_EQ(result.data->command, "touchstone run mine");
  const auto& cells = result.data->baseline.cells;
  ASSERT_EQ(cells.size(), 7U);
  const auto& wrong =
      cells.at({"contact/box_sphere/wrong", "mine", MeasureKind::kSeparationError, ""});
  EXPECT_EQ(wrong.value, 0.01);
  EXPECT_EQ(wrong.verdict, Verdict::kFail);
  EXPECT_GT(wrong.floor, 0);
}

/** Returns the complaint about data of which `change` has changed the JSON. */
template <typename Change>
std::string Complaint(Change change) {
  DataFile file =
      UnpackData(ReportData(HandMadeReport(), kFacts), kMostReportData).file.value();
  change(file.json);
  const ReadReportResult result = ReadReport(PackData(file), "r.data");
  EXPECT_NE(result.data.has_value(), result.diagnostics.size() == 1);
  return result.data ? "" : ToString(result.diagnostics.front());
}

TEST(ReadReport, RefusesWhatRefersToNothing) {
  EXPECT_EQ(Complaint([](DataJson&) {}), "");
  EXPECT_EQ(Complaint([](DataJson& json) { json["findings"]["oracle"][3] = 2; }),
            "r.data:1:1: refers to a oracle that it does not have; expected report.data "
            "of `touchstone run --out DIR`, or that folder");
  for (const char* column : {"question", "measure", "verdict", "law"}) {
    for (const DataJson& bad :
         {DataJson(1000), DataJson(-2), DataJson("x"), DataJson(nullptr), DataJson(0.5)})
      EXPECT_NE(Complaint([&](DataJson& json) { json["findings"][column][3] = bad; }), "")
          << column << bad;
  }
  EXPECT_NE(Complaint([](DataJson& json) { json["findings"]["law"].erase(0); }), "");
  EXPECT_NE(Complaint([](DataJson& json) { json["findings"]["value"][0] = "x"; }), "");
  EXPECT_NE(Complaint([](DataJson& json) { json["questions"][0].erase("rounding"); }),
            "");
  EXPECT_NE(Complaint([](DataJson& json) { json["names"]["measure"][0] = "x"; }), "");
  EXPECT_NE(Complaint([](DataJson& json) { json = DataJson::object(); }), "");
  EXPECT_NE(Complaint([](DataJson& json) { json = 3; }), "");
}

TEST(ReadReport, RefusesOtherVersionsAndHostileLengths) {
  const auto complaint = [](const std::string& inflated) {
    return ToString(ReadReport(Deflated(inflated), "r.data").diagnostics.at(0));
  };
  const auto bytes = [](std::initializer_list<int> of) {
    return std::string(of.begin(), of.end());
  };
  EXPECT_THAT(complaint("TSRD" + bytes({2, 0, 0, 0, 2, 0, 0, 0}) + "{}"),
              HasSubstr("has version 2 of the format, not 1"));
  EXPECT_THAT(complaint("TSRD" + bytes({1, 0, 0, 0, -1, -1, -1, -1}) + "{}"),
              HasSubstr("is cut off"));
  EXPECT_THAT(complaint("TSRD" + bytes({1, 0, 0, 0, 2, 0, 0, 0}) + "[]"),
              HasSubstr("has no JSON in it"));
  EXPECT_THAT(complaint("TSRD"), HasSubstr("is no report data"));
  // A bomb: more than the reader keeps.
  EXPECT_FALSE(ReadReport(Deflated(std::string(1 << 20, ' ')), "r.data", 1 << 16).data);
  EXPECT_FALSE(ReadReportFile("nowhere").data);
}

TEST(WithComparison, AddsTheChangesToTheData) {
  const ReadReportData after =
      ReadReport(ReportData(HandMadeReport(), kFacts), "r.data").data.value();
  Baseline before = after.baseline;
  const LedgerCell cell{"contact/box_sphere/wrong", "mine", MeasureKind::kSeparationError,
                        ""};
  before.cells.at(cell) = {1e-3, Verdict::kFail, 0};
  const std::vector<Change> changes = Compare(before, after.baseline);
  const std::string data = WithComparison(after, {"old", "new", changes});
  const DataJson json = UnpackData(data, kMostReportData).file.value().json;
  ASSERT_EQ(json["compare"]["rows"].size(), 1U);
  const DataJson& row = json["compare"]["rows"][0];
  EXPECT_EQ(row["kind"], "worse");
  EXPECT_EQ(row["before"], 1e-3);
  EXPECT_EQ(row["what"], "was 0.001, is 0.01 m");
  std::ostringstream xml;
  WriteComparisonJUnit({"old", "new", changes}, xml);
  EXPECT_THAT(xml.str(), HasSubstr("tests=\"1\" failures=\"1\""));
  std::ostringstream table;
  WriteComparison({"old", "new", changes}, table);
  EXPECT_THAT(
      table.str(),
      HasSubstr("WORSE: new against old: 1 worse, 0 no longer judged, 0 new, 0 gone, 0 "
                "better\n"));
}

}  // namespace
}  // namespace touchstone
