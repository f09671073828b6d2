#include "reports/accuracy/audit_run.h"

#include <cmath>

#include <fmt/format.h>

#include "reports/accuracy/accuracy.h"
#include "reports/ledger/audit_ledger.h"

namespace touchstone {

std::vector<std::string> AuditRun(const RunReport& report, std::string_view accuracy) {
  std::vector<std::string> faults = FaultsOf(report, AuditLedger(report));
  for (const Finding& finding : report.findings) {
    if (!std::isnan(finding.tolerance)) continue;
    faults.push_back(fmt::format("{}: {} of {} has no tolerance", finding.scenario,
                                 NameOf(finding.measure), finding.oracle));
  }
  for (const std::string& fault : CheckAccuracy(report, accuracy))
    faults.push_back("accuracy of " + fault);
  return faults;
}

}  // namespace touchstone
