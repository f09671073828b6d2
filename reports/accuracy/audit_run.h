#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/run_report.h"

namespace touchstone {

/** Returns what a run of the whole catalogue has to hold besides its verdicts and does
 not, one sentence each: the ledger hides too much or names wrong causes (FaultsOf()), a
 finding has no tolerance, or the worst errors are not those of the table `accuracy`, the
 text of docs/accuracy.md (CheckAccuracy()). */
std::vector<std::string> AuditRun(const RunReport& report, std::string_view accuracy);

}  // namespace touchstone
