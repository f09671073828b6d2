#pragma once

#include "scenarios/scenario.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns whether two scenarios are the same bit for bit: a -0 is not a 0. */
bool SameBits(const Scenario& a, const Scenario& b);

/** Returns whether two worlds, and what is said of them, are the same bit for bit. */
bool SameBits(const WorldScenario& a, const WorldScenario& b);

/** Returns whether two questions are the same bit for bit. */
bool SameBits(const ContactQuery& a, const ContactQuery& b);

}  // namespace touchstone
