#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Largest accepted relative difference between a number that an author derived and the
 law's own. Numbers are written with at least six significant digits: half a unit of the
 sixth, doubled. [-] */
inline constexpr double kNumberSlack = 1e-6;

/** Returns a fault for every "expected_…" of the claim that contradicts the law's own
 value, or that the law does not derive for this world. `truths` pairs the derived values
 with their names. Other numbers only have to be finite: the law reads them. */
std::vector<Fault> FaultsOfNumbers(
    const Claim& claim, const std::vector<std::pair<std::string_view, double>>& truths);

/** Returns the faults of both. */
std::vector<Fault> Joined(std::vector<Fault> faults, std::vector<Fault> more);

/** Returns the number of that name, or `absent`. */
double NumberOr(const Claim& claim, std::string_view name, double absent);

}  // namespace touchstone
