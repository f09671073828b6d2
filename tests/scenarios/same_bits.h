#pragma once

#include "scenarios/scenario.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns whether two scenarios are equal bit for bit: -0 differs from 0. */
bool SameBits(const Scenario& a, const Scenario& b);

/** Returns whether two world scenarios are equal bit for bit. */
bool SameBits(const WorldScenario& a, const WorldScenario& b);

/** Returns whether two queries are equal bit for bit. */
bool SameBits(const ContactQuery& a, const ContactQuery& b);

}  // namespace touchstone
