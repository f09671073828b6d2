#pragma once

#include <string>
#include <vector>

#include "reports/writers/data/json_values.h"

namespace touchstone {

/** One channel of a track: numbers over time, and the step to which they are rounded. */
struct Channel {
  std::vector<double> values;
  double step = 1;  ///< > 0; widened if a value has more than 2^50 steps.
};

/** Returns the step of a channel whose line shall look smooth: a 400th of the range of
 its values, but at most `step` and at least `least`. Values within two of `step` are
 those of a thing that stays, and keep it. */
double SmoothStep(const std::vector<double>& values, double step, double least);

/** Appends `channels`, all of one length, to `blob` and returns the reference to them: a
 `Track` of docs/report_data.md. Each value becomes a whole number of steps. A channel is
 the differences of consecutive numbers, each a zigzag LEB128 varint. A number that is
 not finite repeats the one before it. */
DataJson AddTrack(const std::vector<Channel>& channels, std::string& blob);

}  // namespace touchstone
