#include "reports/writers/json_writer.h"

#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "hand_made_report.h"
#include "json_lines.h"
#include "json_schema.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

std::string Written(const RunReport& report) {
  std::ostringstream out;
  WriteJson(report, out);
  return out.str();
}

nlohmann::json Schema() {
  std::ifstream file(InSourceTree("docs/report.schema.json"));
  return nlohmann::json::parse(file);
}

TEST(WriteJson, EveryLineFollowsThePublishedSchema) {
  const std::vector<nlohmann::json> lines = LinesOf(Written(HandMadeReport()));
  // The run, 2 oracles, 3 scenarios, 7 findings, 6 answers' seconds, 2 entries of the
  // ledger, 1 fault.
  EXPECT_EQ(lines.size(), 22U);
  EXPECT_EQ(lines.front()["kind"], "run");
  for (const nlohmann::json& line : lines)
    EXPECT_EQ(SchemaFaults(Schema(), line), std::vector<std::string>{}) << line;
}

TEST(WriteJson, FollowsASchemaThatForbidsUnknownProperties) {
  const std::string text = Written(HandMadeReport());
  nlohmann::json finding = LinesOf(text, "finding")[0];
  finding["surprise"] = 1;
  nlohmann::json scenario = LinesOf(text, "scenario")[0];
  scenario["truth"].erase("method");
  nlohmann::json oracle = LinesOf(text, "oracle")[0];
  oracle["unit_roundoff"] = "tiny";
  for (const nlohmann::json& line : {finding, scenario, oracle})
    EXPECT_FALSE(SchemaFaults(Schema(), line).empty()) << line["kind"];
}

TEST(WriteJson, ThePublishedSchemaKnowsEveryMeasure) {
  std::vector<std::string_view> names;
  for (const MeasureKind measure : AllMeasures()) names.push_back(NameOf(measure));
  EXPECT_EQ(Schema()["$defs"]["measure"]["enum"], nlohmann::json(names));
}

TEST(WriteJson, RoundTripsEveryBitOfANumber) {
  const RunReport report = HandMadeReport();
  EXPECT_EQ(LinesOf(Written(report), "scenario")[0]["A"]["rotation"][1][2].get<double>(),
            report.scenarios[0].scenario.contact.A.X_WB.R_WB(1, 2));
}

TEST(WriteJson, SaysHowLongEachAnswerTook) {
  RunReport report = HandMadeReport();
  report.scenarios[1].answers[1].seconds = 0.25;
  const std::vector<nlohmann::json> lines = LinesOf(Written(report), "seconds");
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[2]["seconds"], 0);
  EXPECT_EQ(lines[3]["scenario"], "contact/box_sphere/wrong");
  EXPECT_EQ(lines[3]["oracle"], "theirs/float");
  EXPECT_EQ(lines[3]["seconds"], 0.25);
}

/** A report with one finding that has the evidence `proof`. */
RunReport ReportWith(const Proof& proof) {
  RunReport report = HandMadeReport();
  report.findings.resize(1);
  report.findings[0].evidence = std::make_shared<const Proof>(proof);
  return report;
}

TEST(WriteJson, WritesTheNumbersOfAProofThatApplyToIt) {
  const Eigen::Vector3d n_W = Eigen::Vector3d(1, 2, -2) / 3;
  const nlohmann::json finding =
      LinesOf(Written(ReportWith({.kind = ProofKind::kTranslation,
                                  .claim = ProofClaim::kSeparation,
                                  .said = -0.3,
                                  .bound = -0.1,
                                  .n_W = n_W,
                                  .points_W = {{0.1, 0.2, 0.3}}})),
              "finding")[0];
  const nlohmann::json expected = {{"kind", "translation"},
                                   {"claim", "separation"},
                                   {"said", -0.3},
                                   {"bound", -0.1},
                                   {"n", {n_W.x(), n_W.y(), n_W.z()}},
                                   {"points", {{0.1, 0.2, 0.3}}}};
  EXPECT_EQ(finding["evidence"], expected);
}

TEST(WriteJson, WritesTheEvidenceOfEveryKindByTheSchema) {
  for (int kind = 1; kind <= static_cast<int>(ProofKind::kPlaces); ++kind) {
    const Proof proof{.kind = static_cast<ProofKind>(kind),
                      .claim = static_cast<ProofClaim>(
                          kind % (static_cast<int>(ProofClaim::kContact) + 1)),
                      .said = 1,
                      .bound = -HUGE_VAL,
                      .rest = 0.5,
                      .n_W = Eigen::Vector3d::UnitX(),
                      .offset = 2,
                      .claimed_W = Eigen::Vector3d::UnitY(),
                      .points_W = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()},
                      .contacts = {1, 4},
                      .change = "swap: A and B exchanged",
                      .explained = 1e-9,
                      .body = "lid",
                      .time = 0.25};
    const nlohmann::json finding = LinesOf(Written(ReportWith(proof)), "finding")[0];
    EXPECT_EQ(SchemaFaults(Schema(), finding), std::vector<std::string>{}) << finding;
    EXPECT_EQ(finding["evidence"]["kind"], NameOf(proof.kind));
    EXPECT_EQ(finding["evidence"].contains("contacts"),
              proof.kind == ProofKind::kCount || proof.kind == ProofKind::kUnspanned);
  }
}

TEST(WriteJson, WritesTheStudyOfAFindingAndWhatItsProofNames) {
  RunReport report = HandMadeReport();
  report.findings.resize(1);
  report.findings[0].study = StepStudy{{0.4, 0.2, 0.1}, "m/s"};
  report.findings[0].cited = {{"lid", "pot"}, 0.32, {{0, 0.5, 1}}};
  const nlohmann::json finding = LinesOf(Written(report), "finding")[0];
  EXPECT_EQ(finding["study"],
            nlohmann::json({{"errors", {0.4, 0.2, 0.1}}, {"unit", "m/s"}}));
  EXPECT_EQ(finding["time"], 0.32);
  EXPECT_EQ(
      finding["cited"],
      nlohmann::json::parse(R"({"names": ["lid", "pot"], "points": [[0, 0.5, 1]]})"));
  EXPECT_EQ(SchemaFaults(Schema(), finding), std::vector<std::string>{});
}

TEST(WriteJson, OmitsEvidenceStudyMomentAndNamesOfAFindingWithoutThem) {
  const nlohmann::json finding = LinesOf(Written(HandMadeReport()), "finding")[0];
  for (const char* key : {"evidence", "study", "time", "cited"})
    EXPECT_FALSE(finding.contains(key)) << key;
}

TEST(WriteJson, WritesNanAsAString) {
  EXPECT_EQ(LinesOf(Written(HandMadeReport()), "scenario")[1]["answers"][1]["separation"],
            "NaN");
}

TEST(WriteJson, CountsOutcomesPerVerdict) {
  const nlohmann::json run = LinesOf(Written(HandMadeReport())).front();
  EXPECT_EQ(run["outcomes"]["known"], 1);
  EXPECT_EQ(run["outcomes"]["timed out"], 0);
}

}  // namespace
}  // namespace touchstone
