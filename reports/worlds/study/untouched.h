#pragma once

#include <string_view>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Returns whether a motion moves the body or particle `name` up to `until` [s] as if
 nothing but gravity and its force acted on it: it falls, and turns without torque. An
 engine that misses a contact moves it so, and so does one that has none to miss.

 Granted are a step's acceleration, since engines add it before or after they move, and
 1 % of the motion, which no contact of consequence is below. The spin may be constant in
 place of the angular momentum: many engines leave the gyroscopic torque out. */
bool IsUntouched(const Motion& motion, std::string_view name, double until);

}  // namespace touchstone
