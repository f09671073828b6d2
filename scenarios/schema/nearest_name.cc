#include "scenarios/schema/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace touchstone {
namespace {

// Edit distance with the four typing errors of Damerau, "A technique for computer
// detection and correction of spelling errors", CACM 7 (1964), p. 171. One row of the
// table is computed at a time; two earlier rows are kept.
std::size_t EditDistance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before, last, row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, row[j - 1] + 1, last[j] + 1});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
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
    // The distance is at least the difference in length, so a long key is skipped
    // cheaply.
    if (3 * (longer - std::min(name.size(), misspelt.size())) > longer) continue;
    const std::size_t distance = EditDistance(misspelt, name);
    if (3 * distance > longer || distance >= least) continue;
    nearest = name;
    least = distance;
  }
  return nearest;
}

}  // namespace touchstone
