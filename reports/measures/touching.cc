#include "reports/measures/touching.h"

namespace touchstone {

std::optional<bool> CertifiedTouching(const ContactTruth& truth) {
  if (truth.separation.lo > 0) return false;
  if (truth.separation.hi <= 0) return true;
  return std::nullopt;
}

double TouchingError(const ContactTruth& truth, const ContactAnswer& answer) {
  if (truth.touching == Touching::kUndecided) return 0;
  return answer.touching == (truth.touching == Touching::kTouching) ? 0 : 1;
}

}  // namespace touchstone
