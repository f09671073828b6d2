#include "reports/finding/ledger.h"

namespace touchstone {

std::string CausesOf(const LedgerEntry& entry) {
  std::string text;
  for (const Cause cause : entry.causes) {
    if (!text.empty()) text += ", ";
    text += NameOf(cause);
  }
  return text;
}

}  // namespace touchstone
