#include "reports/sweep/block_set.h"

#include <iterator>

namespace touchstone {

bool BlockSet::Add(std::uint64_t first, std::uint64_t last) {
  auto after = ranges_.upper_bound(first);
  if (after != ranges_.end() && after->first <= last) return false;
  auto before = after;
  if (before != ranges_.begin()) {
    --before;
    if (before->second >= first) return false;
    if (before->second + 1 == first) {
      first = before->first;
      ranges_.erase(before);
    }
  }
  if (after != ranges_.end() && after->first == last + 1) {
    last = after->second;
    ranges_.erase(after);
  }
  ranges_.emplace(first, last);
  return true;
}

bool BlockSet::Contains(std::uint64_t block) const {
  const auto after = ranges_.upper_bound(block);
  return after != ranges_.begin() && std::prev(after)->second >= block;
}

std::uint64_t BlockSet::size() const {
  std::uint64_t sum = 0;
  for (const auto& [first, last] : ranges_) sum += last - first + 1;
  return sum;
}

std::optional<std::uint64_t> BlockSet::FirstMissing(std::uint64_t count) const {
  const std::uint64_t missing =
      ranges_.empty() || ranges_.begin()->first > 0 ? 0 : ranges_.begin()->second + 1;
  if (missing >= count) return std::nullopt;
  return missing;
}

}  // namespace touchstone
