#include "reports/measures/touching.h"

namespace touchstone {

double TouchingError(const ContactTruth& truth, const ContactAnswer& answer) {
  if (truth.touching == Touching::kUndecided) return 0;
  return answer.touching == (truth.touching == Touching::kTouching) ? 0 : 1;
}

}  // namespace touchstone
