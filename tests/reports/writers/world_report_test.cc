#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "json_lines.h"
#include "json_schema.h"
#include "reports/writers/data/data_file.h"
#include "reports/writers/explanation_writer.h"
#include "reports/writers/json_writer.h"
#include "reports/writers/junit_writer.h"
#include "reports/writers/read_report_data.h"
#include "reports/writers/report_data.h"
#include "reports/writers/table_writer.h"
#include "reports/writers/world_words.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

Trajectory Fallen(double g) {
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.1 * i;
    trajectory.times.push_back(t);
    trajectory.samples.push_back(
        {{{Eigen::Vector3d(0, 2 - g * t * t / 2, 0), Eigen::Quaterniond::Identity(),
           Eigen::Vector3d(0, -g * t, 0), Eigen::Vector3d::Zero()}},
         {},
         {}});
  }
  return trajectory;
}

OracleInfo Simulator(const std::string& name) {
  OracleInfo info;
  info.name = name;
  info.simulates = true;
  return info;
}

Finding FindingOf(const std::string& oracle, double value) {
  Finding finding;
  finding.scenario = "world/test/fall";
  finding.oracle = oracle;
  finding.reference = "law";
  finding.law = "ballistic";
  finding.measure = MeasureKind::kPositionError;
  finding.value = value;
  finding.tolerance = 0.01;
  finding.tolerance_because = "half a step late";
  if (value > finding.tolerance) {
    finding.verdict = Verdict::kFail;
    finding.proof = "ballistic: it is too light";
  }
  return finding;
}

/** Returns a report on a falling ball: one engine is right, one is too slow, and one does
 not support it. A fourth oracle answers contact queries only. */
RunReport OneWorld() {
  RunReport report;
  report.subject = "mine";
  report.oracles = {Simulator("mine"), Simulator("light"), Simulator("none"), {}};
  report.oracles[3].name = "contacts_only";
  report.oracles[3].capabilities[0][0].supported = true;
  WorldResult world;
  world.scenario.id = "world/test/fall";
  world.scenario.title = "A ball <falls>";
  world.scenario.source = "Galilei";
  world.scenario.world.bodies.emplace_back();
  world.scenario.world.bodies[0].name = "ball";
  world.scenario.world.bodies[0].placed.X_WB =
      Pose::FromQuaternion({0, 2, 0}, Eigen::Quaterniond::Identity());
  world.scenario.world.dt = 0.1;
  world.scenario.world.steps = 10;
  world.scenario.claims.push_back({"ballistic", {"ball"}, {}, ""});
  Trajectory none;
  none.reason = "no balls";
  world.trajectories = {Fallen(9.82), Fallen(9), none, {}};
  world.trajectories[1].complaint = "ODE <Message> 3";
  world.drifts = {{1e-3, 2e-3, 3e-3, 4e-3}, {0.5, 0, 0, 0}, {}, {}};
  world.scenario.ensemble = Ensemble{4, 1e-3, 1};
  world.ensembles = {{4, {48.2, 0.1}, {-2.91, 0.002}, {0.3, 0}},
                     {4, {40.5, 0.1}, {-2.912, 0.002}, {0.3, 0}},
                     {},
                     {}};
  world.seconds = {{2, {{"itself", 1.5}}, {{"ballistic", 0.25}}}, {}, {}, {}};
  report.worlds.push_back(world);
  report.findings = {FindingOf("mine", 0.001), FindingOf("light", 0.41),
                     FindingOf("none", 0)};
  report.findings[2].measure = MeasureKind::kAnswering;
  report.findings[2].verdict = Verdict::kUnsupported;
  report.findings[2].proof = "no balls";
  return report;
}

template <typename Writer>
std::string Written(Writer write) {
  std::ostringstream out;
  write(OneWorld(), out);
  return out.str();
}

TEST(WorldReport, ExplanationComparesTheStatisticsOfEnsembles) {
  const std::string text = Written([](const RunReport& report, std::ostream& out) {
    WriteExplanation(report, {}, out);
  });
  EXPECT_THAT(text, HasSubstr("Ensemble of 4, at the end"));
  EXPECT_THAT(text, ContainsRegex("mine +48.2 ± 0.05 +-2.91 ± 0.001 +0.3 ± 0 "));
  // Energy differs by 154 of its standard errors, height by 2.
  EXPECT_THAT(text, ContainsRegex("light +40.5 ± 0.05 +≠ +-2.912 ± 0.001 +0.3 ± 0 "));
}

TEST(WorldReport, APassThatFailsAsShippedIsListedAndCountedAndFailsNoRun) {
  RunReport report = OneWorld();
  report.findings.resize(1);
  report.findings[0].shipped = Shipped::kShippedOnly;
  report.findings[0].shipped_because =
      "0.3 m where 0.01 m is allowed as shipped; the default margin = 0.04, 0 here, is "
      "enough";
  const auto table = [&](const TableStyle& style) {
    std::ostringstream out;
    WriteTable(report, style, out);
    return out.str();
  };
  constexpr std::string_view kCount =
      "as shipped only: 1 of the passes fail with the engine's own settings";
  EXPECT_THAT(
      table({}),
      AllOf(HasSubstr("As shipped only: right as set here, wrong with the engine's own "
                      "settings\n  mine, world/test/fall: position_error, 0.3 m where "
                      "0.01 m is allowed as shipped; the default margin = 0.04, 0 here, "
                      "is enough.\n"),
            HasSubstr(kCount), HasSubstr("OK: mine never failed")));
  EXPECT_THAT(table({.quiet = true}), AllOf(HasSubstr(kCount), Not(HasSubstr("margin"))));

  // An answer that is wrong either way is listed as wrong.
  report.findings.push_back(FindingOf("mine", 0.41));
  EXPECT_THAT(table({}), Not(HasSubstr("s shipped only")));
}

TEST(WorldReport, DriftsAreShownWhateverTheWorldClaims) {
  constexpr std::string_view kMine =
      "energy gained 0.001 J, lost 0.002 J; momentum 0.003 N s; angular momentum 0.004 N "
      "m s";
  EXPECT_THAT(Written([](const auto& r, auto& out) { WriteExplanation(r, {}, out); }),
              HasSubstr("    measured: " + std::string(kMine) + "\n"));
  EXPECT_THAT(Written([](const auto& r, auto& out) { WriteTable(r, TableStyle{}, out); }),
              ContainsRegex("Measured: [^\n]*\n +mine +" + std::string(kMine)));
  const nlohmann::json world =
      LinesOf(Written([](const auto& r, auto& out) { WriteJson(r, out); }), "world")[0];
  const auto& motions = world["motions"];
  EXPECT_EQ(motions[0]["drifts"]["momentum"], 3e-3);
  EXPECT_TRUE(motions[2]["drifts"].is_null());
}

TEST(WorldReport, DriftsHaveTheToleranceOfALawAndDepthsAreFindings) {
  RunReport report = OneWorld();
  Finding rise = FindingOf("mine", 1e-3);
  rise.measure = MeasureKind::kEnergyDrift;
  rise.law = "energy_never_rises";
  Finding depth = rise;
  depth.measure = MeasureKind::kPenetration;
  depth.law = "never_penetrates";
  const std::vector<Finding> findings = {rise, depth};
  EXPECT_EQ(DriftsInWords(report.worlds[0], 0, findings),
            "energy gained 0.001 J of 0.01 J, lost 0.002 J; momentum 0.003 N s; angular "
            "momentum 0.004 N m s; depth 0.001 m of 0.01 m");
  EXPECT_EQ(DriftsInWords(report.worlds[0], 2, {}), "");
  // The law's worst instant is not the drift of the whole motion.
  rise.value = 2e-4;
  EXPECT_THAT(DriftsInWords(report.worlds[0], 0, {&rise, 1}),
              HasSubstr("energy gained 0.001 J, at worst 0.0002 J of 0.01 J, lost"));
}

TEST(WorldReport, AUniversalLawIsCalledSo) {
  RunReport report = OneWorld();
  report.findings[0].universal = true;
  std::ostringstream text;
  WriteExplanation(report, {}, text);
  EXPECT_THAT(text.str(), HasSubstr("ballistic, universal"));
  std::ostringstream json;
  WriteJson(report, json);
  EXPECT_EQ(LinesOf(json.str(), "finding")[0]["universal"], true);
}

TEST(WorldReport, ExplanationWritesEveryNumberNextToItsTolerance) {
  const std::string text =
      Written([](const auto& r, auto& out) { WriteExplanation(r, {}, out); });
  EXPECT_THAT(
      text,
      HasSubstr(
          "world/test/fall: A ball <falls>\n  source: Galilei\n  1 "
          "body; 10 steps of 100 ms\n  laws: ballistic of ball; and of every motion "));
  EXPECT_THAT(text, HasSubstr("departs from mine at 0.1 s: ball is 0.0041 m off"));
  EXPECT_THAT(text, HasSubstr("position_error"));
  EXPECT_THAT(text,
              HasSubstr("0.001 m of         0.01 m  ballistic                    [1]\n"));
  EXPECT_THAT(text, HasSubstr("\nTolerances:\n  [1] half a step late\n\n"));
  EXPECT_THAT(text, HasSubstr("unsupported no balls"));
  EXPECT_THAT(text, HasSubstr("\n    it printed: ODE <Message> 3\n"));
  EXPECT_THAT(text, HasSubstr("\nRight: mine\nWrong: light\n"));
  EXPECT_THAT(text, Not(HasSubstr("contacts_only")));
}

TEST(WorldReport, NamesTheLegalModelNextToEveryVerdict) {
  RunReport report = OneWorld();
  report.findings[1].verdict = Verdict::kPass;
  report.findings[1].cause = Cause::kModel;
  report.findings[1].cause_because = "moon <gravity>";
  std::ostringstream text;
  WriteExplanation(report, {}, text);
  EXPECT_THAT(text.str(),
              HasSubstr("\nFollows another legal model, moon <gravity>: light\n"));
  EXPECT_THAT(text.str(),
              HasSubstr("pass        recognised: moon <gravity>; departs from"));
}

TEST(WorldReport, ExplanationTableHasALinePerWorld) {
  const std::string text =
      Written([](const auto& r, auto& out) { WriteExplanationTable(r, out); });
  // The one that it claims, and six that are universal.
  EXPECT_THAT(text, HasSubstr("world/test/fall  9 laws"));
  EXPECT_THAT(text, HasSubstr("light\n"));
}

TEST(WorldReport, DataHaveTheCurvesWithTheTruthAndTheMomentOfAFault) {
  const DataFile file =
      UnpackData(ReportData(OneWorld(), {}), kMostReportData).file.value();
  const DataJson& world = file.json["questions"][0]["world"];
  EXPECT_EQ(world["times"].size(), 11U);
  EXPECT_EQ(world["thinned"], 1);
  ASSERT_EQ(world["motions"].size(), 4U);
  EXPECT_EQ(world["motions"][0]["bodies"][0]["scale"].size(), 13U);
  EXPECT_EQ(world["motions"][3]["status"], "not asked");
  const DataJson& height = world["curves"][0];
  EXPECT_EQ(height["quantity"], "y of ball");
  EXPECT_EQ(height["tolerance"], 0.01);
  EXPECT_TRUE(height.contains("truth"));
  EXPECT_TRUE(height["breaks"][0].is_null());
  // Light gravity is 0.41 t² too high: beyond 1 cm from the second sample on.
  EXPECT_EQ(height["breaks"][1], 0.2);
  EXPECT_EQ(height["finding"], 1);
  EXPECT_EQ(height["shows"][1], 1);
  EXPECT_EQ(file.json["findings"]["time"][1], 0.2);
  EXPECT_EQ(file.json["findings"]["first"][1], 0.2);
}

TEST(WorldReport, DataHaveTheErrorOfAPlaceThatAClosedFormGives) {
  const DataFile file =
      UnpackData(ReportData(OneWorld(), {}), kMostReportData).file.value();
  const DataJson& curves = file.json["questions"][0]["world"]["curves"];
  ASSERT_EQ(curves.size(), 4U);
  EXPECT_EQ(curves[1]["quantity"], "position error of ball");
  EXPECT_EQ(curves[1]["tolerance"], 0.01);
  EXPECT_EQ(curves[1]["shows"][1], 1);
  EXPECT_EQ(curves[1]["breaks"][1], 0.2);
}

TEST(WorldReport, DataTellTheFirstBreakApartFromTheWorst) {
  RunReport report = OneWorld();
  report.findings[1].cited.time = 0.9;
  report.findings[1].cited.first_time = 0.1;
  const DataJson findings =
      UnpackData(ReportData(report, {}), kMostReportData).file.value().json["findings"];
  EXPECT_EQ(findings["time"][1], 0.9);
  EXPECT_EQ(findings["first"][1], 0.1);
}

TEST(WorldReport, DataTellTheFirstVelocitiesOfAMotionThatDiverges) {
  RunReport report = OneWorld();
  Trajectory& motion = report.worlds[0].trajectories[1];
  motion.samples.back().bodies[0].v_WB.y() = -1e5;
  motion.diverged_at_step = 11;
  const DataJson json =
      UnpackData(ReportData(report, {}), kMostReportData).file.value().json;
  // The ball falls at 0.9 m/s in the first sample.
  const int y_of_velocity = 8;
  EXPECT_LE(
      json["questions"][0]["world"]["motions"][1]["bodies"][0]["scale"][y_of_velocity]
          .get<double>(),
      0.1);
}

TEST(WorldReport, DataHaveTheBodiesAndThePointsThatAProofNames) {
  RunReport report = OneWorld();
  // A node is no body of the page.
  report.findings[1].cited = {{"node 3", "ball"}, 0.3, {{0, 1.0 / 3, 2}}};
  report.findings[2].cited = {{"node 3"}, 0.3, {}};
  const DataJson cited =
      UnpackData(ReportData(report, {}), kMostReportData).file.value().json["cited"];
  EXPECT_EQ(cited["finding"], DataJson({1}));
  EXPECT_EQ(cited["bodies"], DataJson::parse("[[0]]"));
  EXPECT_EQ(cited["points"], DataJson::parse("[[[0, 0.333333333, 2]]]"));
}

TEST(WorldReport, JsonFollowsItsSchema) {
  const std::string text = Written([](const auto& r, auto& out) { WriteJson(r, out); });
  std::ifstream in(InSourceTree("docs/report.schema.json"));
  const nlohmann::json schema = nlohmann::json::parse(in);
  for (const nlohmann::json& line : LinesOf(text))
    EXPECT_THAT(SchemaFaults(schema, line), testing::IsEmpty()) << line;
  const nlohmann::json world = LinesOf(text, "world")[0];
  const auto& motions = world["motions"];
  ASSERT_EQ(motions.size(), 3U);
  EXPECT_EQ(motions[1]["verdict"], "fail");
  EXPECT_NEAR(motions[1]["end"]["bodies"][0]["position"][1].get<double>(), -2.5, 1e-12);
  EXPECT_TRUE(motions[2]["end"].is_null());
  EXPECT_EQ(motions[1]["complaint"], "ODE <Message> 3");
}

TEST(WorldReport, JUnitHasACaseForEachOracleThatSimulates) {
  const std::string xml =
      Written([](const auto& r, auto& out) { WriteJUnit(r, {}, out); });
  EXPECT_THAT(xml, AllOf(HasSubstr("tests=\"3\""), HasSubstr("failures=\"1\""),
                         HasSubstr("skipped=\"1\"")));
}

TEST(WorldReport, TableCountsOraclesThatDoNotSimulateAsUnsupported) {
  const std::string table =
      Written([](const auto& r, auto& out) { WriteTable(r, TableStyle{}, out); });
  EXPECT_THAT(table, HasSubstr("1 scenario × 4 oracles: 1 pass, 1 fail, 0 disagree, 0 "
                               "known, 0 undecidable, 2 unsupported"));
}

}  // namespace
}  // namespace touchstone
