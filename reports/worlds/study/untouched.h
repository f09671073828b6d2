#pragma once

#include <string_view>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Returns whether a motion leaves the body or particle `name` alone up to `until` [s]:
 it falls under gravity and its force, and turns without torque.

 Granted are roundings, the change of the velocity in one step, since engines add loads
 before or after they move, and 1 % of the motion: a contact that changes less counts as
 none. The spin may be constant in place of the angular momentum, since many engines leave
 the gyroscopic torque out. */
bool IsUntouched(const Motion& motion, std::string_view name, double until);

/** Returns whether something may act on the body or particle `name` up to `until` [s]: a
 spring, a joint, a push, damping, or a thing with which it may collide. Of bodies this
 rules out those that it never comes so near in this motion that they may meet before the
 next sample. Cloths, and bodies for a particle, are taken to be near. */
bool MayBeTouched(const Motion& motion, std::string_view name, double until);

}  // namespace touchstone
