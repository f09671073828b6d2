#include "tests/fuzz/bounds_file_property.h"

#include <cmath>

#include "reports/ledger/bounds_file.h"

namespace touchstone {
namespace {

bool AreSame(const LedgerBounds& a, const LedgerBounds& b) {
  if (a.size() != b.size()) return false;
  for (const auto& [cell, bound] : a) {
    const auto other = b.find(cell);
    if (other == b.end() || other->second.verdict != bound.verdict ||
        other->second.value != bound.value)
      return false;
  }
  return true;
}

}  // namespace

std::string FaultOfReadingBounds(std::string_view text) {
  const BoundsResult read = ReadBounds(text, "f.bounds");
  if (read.bounds.has_value() != read.diagnostics.empty())
    return "neither bounds nor a diagnostic, or both";
  for (const Diagnostic& diagnostic : read.diagnostics) {
    if (diagnostic.line < 1 || diagnostic.column < 1 || diagnostic.what.empty() ||
        diagnostic.expected.empty())
      return "a diagnostic without a place or a text: " + ToString(diagnostic);
  }
  if (!read.bounds) return "";
  for (const auto& [cell, bound] : *read.bounds) {
    if (!std::isfinite(bound.value) || bound.value < 0)
      return "accepted a bound that bounds nothing: " + cell.scenario;
  }
  const std::string written = WriteBounds(*read.bounds, "f.toml");
  const BoundsResult again = ReadBounds(written, "written.bounds");
  if (!again.bounds) return "refused the written file:\n" + written;
  if (!AreSame(*again.bounds, *read.bounds)) return "read back differently:\n" + written;
  if (WriteBounds(*again.bounds, "f.toml") != written) return "not stable:\n" + written;
  return "";
}

}  // namespace touchstone
