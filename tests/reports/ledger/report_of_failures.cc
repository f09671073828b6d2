#include "tests/reports/ledger/report_of_failures.h"

#include <string>

#include "tests/reports/specimens.h"

namespace touchstone {

LedgerCell CellOfFailure(std::size_t i, MeasureKind measure) {
  return {"contact/box_box/" + std::to_string(i), "ode", measure, ""};
}

RunReport ReportOfFailures(std::initializer_list<double> values, double bound) {
  RunReport report;
  OracleInfo info;
  info.name = "ode";
  info.version = "0.16.2";
  report.oracles = {info};
  const ContactQuery query = SphereInBoxFace(1e-3).query;
  for (const double value : values) {
    ScenarioResult result;
    result.scenario.id = "contact/box_box/" + std::to_string(report.scenarios.size());
    result.scenario.contact = query;
    Finding finding{};
    finding.scenario = result.scenario.id;
    finding.oracle = "ode";
    finding.measure = MeasureKind::kExcess;
    finding.value = value * SceneSize(query);
    finding.verdict = value > 0 ? Verdict::kFail : Verdict::kPass;
    finding.proof = value > 0 ? "It is wrong." : "";
    report.ledger.bounds[CellOfFailure(report.scenarios.size())] = {
        Verdict::kFail, bound, static_cast<int>(report.scenarios.size()) + 3};
    report.scenarios.push_back(result);
    report.findings.push_back(finding);
  }
  LedgerEntry entry;
  entry.scenarios = {"contact/box_box/*"};
  entry.oracle = "ode";
  entry.version = "0.16.2";
  entry.measures = {MeasureKind::kExcess};
  entry.expires = "2026-06-30";
  entry.line = 17;
  report.ledger.file = "scenarios/known_discrepancies.toml";
  report.ledger.entries = {entry};
  return report;
}

}  // namespace touchstone
