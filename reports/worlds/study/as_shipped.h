#pragma once

#include <span>

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Asks a world again with the engine's shipped settings, and sets Finding::shipped for
 each finding that fails with either setup. `motion` is the motion that `findings` judge.

 A world with a failure is always asked again, with as many motions as its failures need.
 A world without one is asked again if it is small, with one motion. A finding that passes
 here is compared only in a small world, and only if one motion is enough to judge it.

 The settings that decide (DecidingDefaults) are named for what fails here only and, if
 nothing fails here, for what fails as shipped only. An oracle that is set up as shipped
 is not asked again. */
void CompareWithShipped(const WorldScenario& scenario, const Oracle& oracle,
                        const Trajectory& motion, std::span<Finding> findings);

}  // namespace touchstone
