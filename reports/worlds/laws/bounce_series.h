#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A sphere, or another body that lands flat (LiesFlat()), falls straight down onto a
 static plane and leaves each bounce with e times its speed (truth/vertical_bounces.h).
 [m], [-]

 The tolerances are in law_support/falls.h, with the rule that reflects the velocity after
 gravity, which is recognised.

 About: spheres and bodies that lie flat, at rest or moving along gravity, above a static
 half-space or box. Numbers, valid for all of them: expected_first_impact,
 expected_impact_speed, expected_total_time, expected_first_apex. */
extern const Law kBounceSeries;

}  // namespace touchstone
