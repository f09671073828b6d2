#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook {

/** What the shares of a task find, see ThreadPool::ParallelForIndexed(): share after
 share, so in the order of what they looked at. */
template <class Found>
class PerThread {
 public:
  /** Forgets all. `shares`: of the pool. */
  void Clear(std::size_t shares) {
    shares_.resize(shares);
    for (Share& share : shares_) share.found.clear();
  }

  /** What one share has found: for that share alone, while they work. */
  std::vector<Found>& Of(std::size_t share) { return shares_[share].found; }

  /** Appends all to `list`. */
  void AppendTo(std::vector<Found>& list) const {
    for (const Share& share : shares_) {
      list.insert(list.end(), share.found.begin(), share.found.end());
    }
  }

  template <class Visit>
  void ForEach(const Visit& visit) const {
    for (const Share& share : shares_) {
      for (const Found& found : share.found) visit(found);
    }
  }

  /** The same, the last first. */
  template <class Visit>
  void ForEachBackwards(const Visit& visit) const {
    for (auto share = shares_.rbegin(); share != shares_.rend(); ++share) {
      std::for_each(share->found.rbegin(), share->found.rend(), visit);
    }
  }

 private:
  /** In lines of a cache of its own: each finds without disturbing the others. */
  struct alignas(64) Share {
    std::vector<Found> found;
  };

  std::vector<Share> shares_;
};

}  // namespace cookbook
