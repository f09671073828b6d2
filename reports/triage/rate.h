#pragma once

#include <cstdint>
#include <string>

namespace touchstone {

/** How many of the questions of a sweep fail. */
struct Rate {
  std::uint64_t failed = 0;
  std::uint64_t asked = 0;

  Rate& operator+=(const Rate& other) {
    failed += other.failed;
    asked += other.asked;
    return *this;
  }
};

/** Returns failed / asked; 0 if nothing was asked. [-] */
double ShareOf(const Rate& rate);

/** The ends of an interval. [-] */
struct ShareInterval {
  double lo = 0;
  double hi = 1;
};

/** Returns Wilson's interval of 95 % for the probability that a question of the family
 fails. Source: E. B. Wilson, Probable inference, the law of succession, and statistical
 inference, J. Am. Stat. Assoc. 22 (1927). */
ShareInterval IntervalOf(const Rate& rate);

/** Returns "17 of 256, 6.64 % (4.19 % to 10.4 %)". */
std::string ToString(const Rate& rate);

}  // namespace touchstone
