#pragma once

#include <string>
#include <string_view>

#include "reports/run_report.h"

namespace touchstone {

/** Returns the text of the ledger of `report` with the causes that its findings have, in
 the order of the enumeration, in each entry that contradicts them, see AuditLedger(). The
 rest of the text stays as it is. A person reviews whether the reasons still fit.
 @param text The ledger's file. `cause` starts a line of its own there and ends on it. */
std::string RewriteCauses(std::string_view text, const RunReport& report);

}  // namespace touchstone
