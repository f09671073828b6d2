#include "reports/shrink/same_fault.h"

#include <algorithm>
#include <regex>

#include "reports/finding/tolerance.h"

namespace touchstone {
namespace {

double ExcessOf(const Finding& finding) {
  return InTolerances(finding.value, finding.tolerance);
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
