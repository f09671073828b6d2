#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A sphere, or a box that lands flat, falls straight down on a static plane and leaves
 each time with the share e of its speed (truth/vertical_bounces.h). [m], [-]

 Tolerances, and the rule that reflects the velocity after gravity, which is recognised:
 laws/falls.h.

 About: spheres and flat boxes at rest or moving along gravity, above a static half-space
 or box. Numbers: expected_first_impact, expected_impact_speed, expected_total_time,
 expected_first_apex, for all of them. */
extern const Law kBounceSeries;

}  // namespace touchstone
