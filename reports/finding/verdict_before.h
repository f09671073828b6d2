#pragma once

#include <span>

#include "reports/finding/finding.h"
#include "reports/finding/ledger.h"

namespace touchstone {

/** Returns the verdict of a finding before the ledger was applied.
 @param entries The entries of that ledger. */
Verdict VerdictBefore(const Finding& finding, std::span<const LedgerEntry> entries);

}  // namespace touchstone
