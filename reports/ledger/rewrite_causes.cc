#include "reports/ledger/rewrite_causes.h"

#include <map>
#include <vector>

#include "reports/ledger/audit_ledger.h"
#include "reports/ledger/ledger_file.h"

namespace touchstone {

std::string RewriteCauses(std::string_view text, const RunReport& report) {
  std::map<int, std::string> lines;  // The new line of each entry, keyed by its place.
  for (const LedgerAudit::Contradiction& of : AuditLedger(report).contradictions) {
    std::vector<Cause> causes;
    for (const auto& [cause, findings] : report.ledger_use[of.entry].causes) {
      if (cause != Cause::kNone) causes.push_back(cause);
    }
    lines[report.ledger.entries[of.entry].line] = CauseLine(causes);
  }
  std::string rewritten;
  const std::string* next = nullptr;  // To be written over the next line of a cause.
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    if (line.starts_with("[[")) next = nullptr;
    if (const auto found = lines.find(number); found != lines.end())
      next = &found->second;
    if (next != nullptr && line.starts_with("cause")) {
      rewritten += *next;
      next = nullptr;
    } else {
      rewritten += line;
    }
    if (end == std::string_view::npos) break;
    rewritten += '\n';
    text.remove_prefix(end + 1);
  }
  return rewritten;
}

}  // namespace touchstone
