#include "reports/shrink/same_fault.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

namespace touchstone {
namespace {

// The value in tolerances. Infinite for a NaN, and where none is allowed.
double ExcessOf(const Finding& finding) {
  if (std::isnan(finding.value)) return std::numeric_limits<double>::infinity();
  return finding.value / finding.tolerance;
}

}  // namespace

std::string KindOfProof(const std::string& proof) {
  // Also hexadecimal numbers, and exponents with a sign.
  static const std::regex number("-?[0-9][0-9A-Za-z.]*([-+][0-9]+)?");
  return std::regex_replace(proof, number, "#");
}

bool IsSameFault(const Finding& finding, const Finding& original) {
  return finding.oracle == original.oracle && finding.measure == original.measure &&
         finding.law == original.law && finding.verdict == original.verdict &&
         finding.cause == original.cause && finding.grade >= original.grade &&
         ExcessOf(finding) >= std::min(ExcessOf(original) / 2, kClearExcess) &&
         KindOfProof(finding.proof) == KindOfProof(original.proof);
}

}  // namespace touchstone
