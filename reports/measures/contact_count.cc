#include "reports/measures/contact_count.h"

#include <algorithm>

namespace touchstone {

int ContactCountError(int least, std::span<const ContactPoint> contacts, double same) {
  int repeated = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto earlier = contacts.first(i);
    repeated += std::any_of(earlier.begin(), earlier.end(), [&](const ContactPoint& c) {
      return (c.p_WC - contacts[i].p_WC).norm() < same;
    });
  }
  const int missing = least - (static_cast<int>(contacts.size()) - repeated);
  return std::max({missing, repeated, 0});
}

}  // namespace touchstone
