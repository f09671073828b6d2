#include "reports/writers/data/kept_samples.h"

#include <algorithm>
#include <set>

namespace touchstone {

std::vector<std::size_t> KeptSamples(std::span<const double> times, std::size_t n,
                                     std::vector<double> moments,
                                     std::span<const std::size_t> lengths) {
  constexpr std::size_t kMostMoments = 8;
  std::set<std::size_t> kept;
  for (std::size_t i = 0; i < times.size(); i += n) kept.insert(i);
  if (times.size() > 1) kept.insert({1, times.size() - 1});
  for (const std::size_t length : lengths) {
    if (length > 0) kept.insert(length - 1);
  }
  std::ranges::sort(moments);
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  moments.resize(std::min(moments.size(), kMostMoments));
  for (const double moment : moments) {
    const auto at =
        static_cast<std::size_t>(std::ranges::lower_bound(times, moment) - times.begin());
    if (at > 0) kept.insert(at - 1);
    if (at < times.size()) kept.insert(at);
  }
  return {kept.begin(), kept.end()};
}

}  // namespace touchstone
