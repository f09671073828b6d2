#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A particle that falls on a static plane leaves each time with the share `bounce` of
 its normal speed, and keeps its speed along the plane (truth/vertical_bounces.h). [m],
 [-]

 Tolerances, and the rule that reflects the velocity after gravity, which is recognised:
 laws/falls.h.

 About: particles without damping that nothing holds, above a static half-space or box
 whose normal is that of gravity. Numbers: expected_first_impact, expected_impact_speed,
 expected_total_time, expected_first_apex, for all of them. */
extern const Law kParticleBounce;

}  // namespace touchstone
