#include "reports/finding.h"

#include <array>

namespace touchstone {

std::string_view NameOf(Verdict verdict) {
  constexpr std::array<std::string_view, 9> kNames = {
      "pass",        "fail",    "disagree",  "known",  "undecidable",
      "unsupported", "crashed", "timed out", "invalid"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string_view NameOf(Cause cause) {
  constexpr std::array<std::string_view, 7> kNames = {
      "", "convention", "tie", "precision", "discretisation", "model", "defect"};
  return kNames[static_cast<std::size_t>(cause)];
}

}  // namespace touchstone
