#include "reports/shrink/same_fault.h"

#include <algorithm>

#include "reports/finding/ending.h"
#include "reports/finding/tolerance.h"

namespace touchstone {
namespace {

double ExcessOf(const Finding& finding) {
  return InTolerances(finding.value, finding.tolerance);
}

}  // namespace

bool IsSameFault(const Finding& finding, const Finding& original) {
  return finding.oracle == original.oracle && finding.measure == original.measure &&
         finding.law == original.law && finding.verdict == original.verdict &&
         finding.cause == original.cause && finding.grade >= original.grade &&
         ExcessOf(finding) >= std::min(ExcessOf(original) / 2, kClearExcess) &&
         KindOfProof(finding.proof) == KindOfProof(original.proof);
}

}  // namespace touchstone
