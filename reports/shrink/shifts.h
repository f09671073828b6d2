#pragma once

#include <cstddef>
#include <vector>

#include "scenarios/scenario.h"

namespace touchstone {

/** The number of ShiftsOf() a question. */
inline constexpr std::size_t kShifts = 20;

/** Returns questions near that of `scenario`: B is moved by 1 % of SmallestFeature()
 towards each vertex of a dodecahedron, and turned about the same axis such that points at
 SmallerExtent() move as far. The expected answer and the indictments are removed. */
std::vector<Scenario> ShiftsOf(const Scenario& scenario);

}  // namespace touchstone
