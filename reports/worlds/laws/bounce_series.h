#pragma once

#include "reports/worlds/law.h"

namespace touchstone {

/** A sphere, or a box that lands flat, falls straight down on a static plane and leaves
 each time with the share e of its speed (truth/vertical_bounces.h). [m], [-]

 Position: what an engine that sees contacts once a step is off by is computed: the fall
 is stepped by the rule that reflects the velocity at the start of the step, seen touching
 and seen ahead, from eight gaps a fraction of V h apart, since where in its step the
 impact falls is chance; the largest error so far, × 1.5, and 64 roundings a step. An
 impact is at most a step late, which at the speed V is V h more.

 Restitution: v'/v of the samples around each bounce, of which gravity may have changed
 each by g times the time between them, and a step more: (1 + e) g (Δt + h)/V, × 1.5.
 Bounces for which that exceeds ¼ are too slow to tell.

 A motion whose every bounce obeys v' = −e (v − g h), to rounding and the step's number
 being whole, is recognised: "reflects the velocity after gravity". It adds m g h V a
 bounce.

 About: spheres and flat boxes at rest or moving along gravity, above a static half-space
 or box. Numbers: expected_first_impact, expected_impact_speed, expected_total_time,
 expected_first_apex, for all of them. */
extern const Law kBounceSeries;

}  // namespace touchstone
