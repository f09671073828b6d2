#pragma once

#include <optional>

namespace cookbook {

/** Returns when height + speed t + load t²/2 falls below 0, t >= 0. Units as long as they
 agree, [m], [m/s], [m/s²].
 @pre height >= 0. */
std::optional<double> TimeOfFall(double height, double speed, double load);

}  // namespace cookbook
