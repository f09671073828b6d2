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

bool IsSameFault(const Finding& finding, const Finding& original,
                 std::optional<double> over) {
  const bool is_large_enough =
      over ? finding.value > *over
           : finding.grade >= original.grade &&
                 ExcessOf(finding) >= std::min(ExcessOf(original) / 2, kClearExcess);
  return finding.oracle == original.oracle && finding.measure == original.measure &&
         finding.law == original.law && finding.verdict == original.verdict &&
         finding.cause == original.cause && is_large_enough &&
         KindOfProof(finding.proof) == KindOfProof(original.proof);
}

}  // namespace touchstone
