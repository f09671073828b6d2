#include "scenarios/schema/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace touchstone {
namespace {

// Wagner & Fischer, "The string-to-string correction problem", J. ACM 21 (1974), section
// 4, one row at a time.
std::size_t EditDistance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view NearestName(std::string_view misspelt,
                             std::span<const std::string_view> names) {
  std::string_view nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string_view name : names) {
    const std::size_t longer = std::max(name.size(), misspelt.size());
    // At least as far apart as they differ in length: a long key costs nothing.
    if (3 * (longer - std::min(name.size(), misspelt.size())) > longer) continue;
    const std::size_t distance = EditDistance(misspelt, name);
    if (3 * distance > longer || distance >= least) continue;
    nearest = name;
    least = distance;
  }
  return nearest;
}

}  // namespace touchstone
