#include "reports/measures/separation_error.h"

#include "reports/measures/outside.h"

namespace touchstone {

double SeparationError(const ContactTruth& truth, double separation) {
  return Outside(separation, truth.separation);
}

}  // namespace touchstone
