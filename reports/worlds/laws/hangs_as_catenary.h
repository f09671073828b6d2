#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A chain of points on rods, or on springs, between two fixed places, or from one, hangs
 as the discrete catenary (truth/catenary.h). [m]

 Held at the last sample, or from the time `from` on. What is left of the motion then: the
 largest distance from rest at the start, times √n for n points and e^{−γ t}, γ the
 slowest decay of small motion (truth/net.h) by the particles' damping; × 1.5. 1e-5 of the
 chain for the solver of rods, and 64 roundings a step.

 About: bodies held at their centres, or particles, in the order of the chain; without
 damping they must start where they rest. Numbers: from [s]; expected_horizontal_tension,
 expected_largest_tension [N], expected_sag: how far the lowest point is below the higher
 end [m]. */
extern const Law kHangsAsCatenary;

}  // namespace touchstone
