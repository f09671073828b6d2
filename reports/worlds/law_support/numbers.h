#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Largest accepted difference of a number that an author derived from the law's own,
 relative to it: numbers are written with at least six significant digits, so half a unit
 of the sixth; doubled. [-] */
inline constexpr double kNumberSlack = 1e-6;

/** Returns a fault for every "expected_…" of the claim that contradicts the law's own
 truth, or that the law does not derive of this world. `truths` pairs what it derives with
 its name. Other numbers need but be finite: the law reads them. */
std::vector<Fault> FaultsOfNumbers(
    const Claim& claim, const std::vector<std::pair<std::string_view, double>>& truths);

/** Returns the faults of both. */
std::vector<Fault> Joined(std::vector<Fault> faults, std::vector<Fault> more);

/** Returns the number of that name, or `absent`. */
double NumberOr(const Claim& claim, std::string_view name, double absent);

}  // namespace touchstone
