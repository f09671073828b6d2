#include "reports/finding/verdict_before.h"

#include <cstddef>

namespace touchstone {

Verdict VerdictBefore(const Finding& finding, std::span<const LedgerEntry> entries) {
  return finding.ledger_entry
             ? entries[static_cast<std::size_t>(*finding.ledger_entry)].verdict
             : finding.verdict;
}

}  // namespace touchstone
