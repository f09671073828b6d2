#pragma once

#include <span>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Says of the findings of one world and one oracle whose fault a failure is: that of the
 engine or that of the settings of its adapter. If any finding fails, the world is asked
 again with the engine's shipped settings, and Finding::shipped is set for each finding
 that either setup fails. A finding that fails as set here only names the parameter whose
 default alone lets it pass. Worlds without a failure, and oracles set up as shipped, are
 not asked again. */
void CompareWithShipped(const WorldScenario& scenario, const Oracle& oracle,
                        std::span<Finding> findings);

}  // namespace touchstone
