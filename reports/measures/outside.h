#pragma once

#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns the distance of `value` from the interval, 0 inside it. It is the provable
 part of an error if the truth is known as an enclosure: the width of the enclosure is
 never held against an engine. NaN for a NaN. */
inline double Outside(double value, const Enclosure& truth) {
  if (value >= truth.lo && value <= truth.hi) return 0;
  return value < truth.lo ? truth.lo - value : value - truth.hi;
}

/** Returns the distance between two intervals, 0 if they overlap. */
inline double Apart(const Enclosure& a, const Enclosure& b) {
  if (a.hi < b.lo) return b.lo - a.hi;
  return a.lo > b.hi ? a.lo - b.hi : 0;
}

}  // namespace touchstone
