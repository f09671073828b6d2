#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "reports/run_report.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the contents and steps of a world: "3 bodies (1 of them static), 2 springs;
 480 steps of 4.16667 ms". */
std::string Describe(const World& world);

/** Returns the laws that a world claims, and those that are judged of every motion:
 "ballistic of ball; and of every motion momentum_balance, never_penetrates". */
std::string ClaimsOf(const WorldScenario& scenario);

/** Returns what a motion drifts by and how deep its bodies are, measured whatever the
 world claims, with the tolerance where a law of `findings`, those of the motion, gives
 one: "energy gained 1e-12 J of 3e-10 J, lost 2 J; …". Empty if it was not answered. */
std::string DriftsInWords(const WorldResult& world, std::size_t oracle,
                          std::span<const Finding> findings);

/** Returns when and where the motion of oracle `o` first differs from the subject's by
 more than a thousandth of the size of the scene: "departs from cookbook at 0.35 s: ball
 is 0.0123 m off". Empty if it never does, or if either has no motion. The text is for
 display only and affects no verdict. */
std::string Parting(const RunReport& report, const WorldResult& world, std::size_t o);

}  // namespace touchstone
