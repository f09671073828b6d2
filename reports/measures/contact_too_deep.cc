#include "reports/measures/contact_too_deep.h"

#include <algorithm>

namespace touchstone {

double ContactTooDeep(const ContactTruth& truth, const ContactPoint& contact) {
  return std::max(0.0, truth.separation.lo - contact.separation);
}

}  // namespace touchstone
