#include "cli/commands/audit_run.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "reports/accuracy/accuracy.h"
#include "reports/ledger/audit_ledger.h"
#include "reports/writers/outcome.h"

namespace touchstone {

std::string ReadAccuracy(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in || text.empty()) {
    throw InputError(fmt::format(
        "cannot read {}; expected what `touchstone accuracy` prints", file.string()));
  }
  return text;
}

void AuditRun(RunReport& report, const std::string& accuracy) {
  std::vector<std::string> faults = FaultsOf(report, AuditLedger(report));
  for (const Finding& finding : report.findings) {
    if (std::isnan(finding.tolerance))
      faults.push_back("no tolerance: " + Sentence(finding));
  }
  for (const std::string& fault : CheckAccuracy(report, accuracy))
    faults.push_back("accuracy of " + fault);
  report.faults.insert(report.faults.end(), faults.begin(), faults.end());
}

}  // namespace touchstone
