#pragma once

#include <string>

#include "reports/run_report.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns what is in a world: "3 bodies (1 of them static), 2 springs; 480 steps of
 4.16667 ms". */
std::string Describe(const World& world);

/** Returns what is claimed of it: "ballistic of ball; conserves_energy". */
std::string ClaimsOf(const WorldScenario& scenario);

/** Returns when and where the motion by oracle `o` first parts from the subject's by more
 than a thousandth of the size of the scene: "parts from cookbook at 0.35 s: ball is
 0.0123 m off". Empty where it does not, or where either has no motion. For the eye: it
 decides nothing. */
std::string Parting(const RunReport& report, const WorldResult& world, std::size_t o);

}  // namespace touchstone
