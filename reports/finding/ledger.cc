#include "reports/finding/ledger.h"

#include <array>

namespace touchstone {

std::string_view NameOf(Responsible responsible) {
  constexpr std::array<std::string_view, 3> kNames = {"engine", "adapter", "model"};
  return kNames[static_cast<std::size_t>(responsible)];
}

std::string FaultOf(const LedgerEntry& entry) {
  if (!entry.fault.empty()) return entry.fault;
  const std::string& reason = entry.reason;
  // A stop before a small letter ends an abbreviation.
  for (std::size_t i = reason.find(". "); i != std::string::npos;
       i = reason.find(". ", i + 1)) {
    const char next = reason[i + 2];
    if (next < 'a' || next > 'z') return reason.substr(0, i + 1);
  }
  return reason.ends_with('.') ? reason : reason + '.';
}

std::string CausesOf(const LedgerEntry& entry) {
  std::string text;
  for (const Cause cause : entry.causes) {
    if (!text.empty()) text += ", ";
    text += NameOf(cause);
  }
  return text;
}

}  // namespace touchstone
