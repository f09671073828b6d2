#pragma once

#include <span>

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Says of the findings of one world and one oracle whether they depend on the settings
 of its adapter. `motion` is the motion of the world that they judge. The world is asked
 again with the engine's shipped settings if any finding fails, or if that is about as
 cheap as a motion of a studied world: from one motion unless a failure needs more.
 Finding::shipped is set for each finding that either setup fails; what passes here is
 compared if that is cheap, by what one motion tells. What fails here only names the
 settings that decide, see DecidingDefaults; so does what fails as shipped only if nothing
 fails here. An oracle that is set up as shipped is not asked again. */
void CompareWithShipped(const WorldScenario& scenario, const Oracle& oracle,
                        const Trajectory& motion, std::span<Finding> findings);

}  // namespace touchstone
