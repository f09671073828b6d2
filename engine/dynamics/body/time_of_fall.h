#pragma once

#include <optional>

namespace cookbook {

/** Returns the first t >= 0 at which height + speed t + acceleration t²/2 falls below 0.
 The units are [m], [m/s], [m/s²] or any others that agree.
 @pre height >= 0. */
std::optional<double> TimeOfFall(double height, double speed, double acceleration);

}  // namespace cookbook
