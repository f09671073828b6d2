#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace touchstone {

/** Returns the median of `values`; of an even number of values, the upper of the two in
 the middle.
 @pre `values` is not empty. */
inline double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace touchstone
