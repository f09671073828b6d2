#pragma once

#include <filesystem>
#include <string>

#include "reports/run_report.h"

namespace touchstone {

/** Returns the text of a published table of accuracy. Throws InputError. */
std::string ReadAccuracy(const std::filesystem::path& file);

/** Audits a run of the whole catalogue and adds what is not in order to its faults: the
 ledger hides too much or names wrong causes (FaultsOf()); a finding has no tolerance; or
 the worst errors are not those of the table `accuracy`, the text of docs/accuracy.md. */
void AuditRun(RunReport& report, const std::string& accuracy);

}  // namespace touchstone
