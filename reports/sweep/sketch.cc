#include "reports/sweep/sketch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace touchstone {
namespace {

/** Bits of the fraction that a bin ignores. A double has 52; the upper three number the
 eight bins of a power of two. */
constexpr int kDropped = 52 - 3;

}  // namespace

void Sketch::Merge(const Sketch& other) {
  for (const auto& [bin, count] : other.bins_) bins_[bin] += count;
}

std::uint64_t Sketch::count() const {
  std::uint64_t sum = 0;
  for (const auto& [bin, count] : bins_) sum += count;
  return sum;
}

double Sketch::Quantile(double q) const {
  if (bins_.empty()) return 0;
  const auto rank = static_cast<std::uint64_t>(
      std::max(1.0, std::ceil(q * static_cast<double>(count()))));
  std::uint64_t below = 0;
  for (const auto& [bin, in_bin] : bins_) {
    below += in_bin;
    if (below >= rank) return LeastOf(bin);
  }
  return LeastOf(bins_.rbegin()->first);
}

Sketch::Bin Sketch::BinOf(double value) {
  if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  if (value <= 0) return 0;
  return static_cast<Bin>(std::bit_cast<std::uint64_t>(value) >> kDropped);
}

double Sketch::LeastOf(Bin bin) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(bin) << kDropped);
}

}  // namespace touchstone
