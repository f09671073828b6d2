#include "reports/writers/data/track.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace touchstone {
namespace {

void AppendVarint(std::int64_t number, std::string& blob) {
  auto zigzag = (static_cast<std::uint64_t>(number) << 1) ^
                static_cast<std::uint64_t>(number >> 63);
  for (; zigzag >= 0x80; zigzag >>= 7) blob += static_cast<char>(zigzag | 0x80);
  blob += static_cast<char>(zigzag);
}

/** Returns the step of a channel, so wide that no number exceeds 2^50: its differences
 are then exact in the doubles of a browser. */
double StepOf(const Channel& channel) {
  double largest = 0;
  for (const double value : channel.values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  const double least = largest * 0x1p-50;
  const double step = std::max(channel.step, least);
  return step > 0 ? step : 1;
}

}  // namespace

double SmoothStep(const std::vector<double>& values, double step, double least) {
  // Finer than a pixel of a plot.
  constexpr double kLevels = 400;
  double lo = HUGE_VAL;
  double hi = -HUGE_VAL;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  return hi - lo > 2 * step ? std::min(step, std::max(least, (hi - lo) / kLevels)) : step;
}

DataJson AddTrack(const std::vector<Channel>& channels, std::string& blob) {
  DataJson track;
  track["at"] = blob.size();
  track["samples"] = channels.empty() ? 0 : channels.front().values.size();
  track["scale"] = DataJson::array();
  for (const Channel& channel : channels) {
    // The rounded step is what a reader multiplies by.
    const DataJson rounded = ToData(StepOf(channel), 3);
    const double step = rounded.get<double>();
    track["scale"].push_back(rounded);
    std::int64_t before = 0;
    for (const double value : channel.values) {
      const std::int64_t now = std::isfinite(value) ? std::llround(value / step) : before;
      AppendVarint(now - std::exchange(before, now), blob);
    }
  }
  return track;
}

}  // namespace touchstone
