#include "reports/writers/json_writer.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "hand_made_report.h"
#include "json_lines.h"
#include "json_schema.h"

namespace touchstone {
namespace {

std::string Written(const RunReport& report) {
  std::ostringstream out;
  WriteJson(report, out);
  return out.str();
}

nlohmann::json Schema() {
  std::ifstream file(TOUCHSTONE_REPORT_SCHEMA);
  return nlohmann::json::parse(file);
}

TEST(WriteJson, EveryLineFollowsThePublishedSchema) {
  const std::vector<nlohmann::json> lines = LinesOf(Written(HandMadeReport()));
  // The run, 2 oracles, 3 scenarios, 7 findings, 2 entries of the ledger, 1 fault.
  EXPECT_EQ(lines.size(), 16U);
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

TEST(WriteJson, RoundTripsEveryBitOfANumber) {
  const RunReport report = HandMadeReport();
  EXPECT_EQ(LinesOf(Written(report), "scenario")[0]["A"]["rotation"][1][2].get<double>(),
            report.scenarios[0].scenario.contact.A.X_WB.R_WB(1, 2));
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
