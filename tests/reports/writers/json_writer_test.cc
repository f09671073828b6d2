#include "reports/writers/json_writer.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "hand_made_report.h"
#include "json_schema.h"

namespace touchstone {
namespace {

nlohmann::json Written(const RunReport& report) {
  std::ostringstream out;
  WriteJson(report, out);
  return nlohmann::json::parse(out.str());
}

nlohmann::json Schema() {
  std::ifstream file(TOUCHSTONE_REPORT_SCHEMA);
  return nlohmann::json::parse(file);
}

TEST(WriteJson, FollowsThePublishedSchema) {
  EXPECT_EQ(SchemaFaults(Schema(), Written(HandMadeReport())),
            std::vector<std::string>{});
}

TEST(WriteJson, FollowsASchemaThatForbidsUnknownProperties) {
  nlohmann::json report = Written(HandMadeReport());
  report["findings"][0]["surprise"] = 1;
  report["scenarios"][0]["truth"].erase("method");
  report["oracles"][0]["unit_roundoff"] = "tiny";
  EXPECT_EQ(SchemaFaults(Schema(), report).size(), 3u);
}

TEST(WriteJson, RoundTripsEveryBitOfANumber) {
  const RunReport report = HandMadeReport();
  const nlohmann::json json = Written(report);
  EXPECT_EQ(json["scenarios"][0]["A"]["rotation"][1][2].get<double>(),
            report.scenarios[0].scenario.contact.A.X_WB.R_WB(1, 2));
}

TEST(WriteJson, WritesNanAsAString) {
  EXPECT_EQ(Written(HandMadeReport())["scenarios"][1]["answers"][1]["separation"], "NaN");
}

TEST(WriteJson, CountsOutcomesPerVerdict) {
  const nlohmann::json json = Written(HandMadeReport());
  EXPECT_EQ(json["outcomes"]["known"], 1);
  EXPECT_EQ(json["outcomes"]["timed out"], 0);
}

}  // namespace
}  // namespace touchstone
