#pragma once

#include <string_view>

#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

// Claims that are no laws, since no single motion can show them.

/** The claim that a second run gives the same bits. */
inline constexpr std::string_view kDeterministic = "deterministic";

/** The claim that the motion amplifies a change of its start at most `gain` times, a
 number of the claim. Variants are then compared to the end, however much an engine
 amplifies rounding. The claim applies only to worlds with IsStudied(). */
inline constexpr std::string_view kStable = "stable";
inline constexpr std::string_view kStableGain = "gain";

/** Returns the first claim of `scenario` with that law, or null. */
const Claim* FindClaim(const WorldScenario& scenario, std::string_view law);

}  // namespace touchstone
