#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A particle that falls onto a static plane leaves each bounce with `bounce` times its
 normal speed and keeps its speed along the plane (truth/vertical_bounces.h). [m], [-]

 The tolerances are in law_support/falls.h, with the rule that reflects the velocity after
 gravity, which is recognised.

 About: particles without damping that nothing holds, above a static half-space or box
 whose normal is opposite to gravity. Numbers, valid for all of them:
 expected_first_impact, expected_impact_speed, expected_total_time,
 expected_first_apex. */
extern const Law kParticleBounce;

}  // namespace touchstone
