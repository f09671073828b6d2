#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A box is driven by a force over a level plane, with balls that roll on it
 (SimBenchmark "rolling"). [m/s], [rad/s]

 Balls of mass m and inertia k m r² roll without slip: each resists the box by m a k/(1 +
 k) and moves at a k/(1 + k), so that
   a = (F − μ g (M + Σ m))/(M + Σ m k/(1 + k)),  α = a/((1 + k) r)
 along the force F, zero if friction holds it. Velocities are exact for any step, as on a
 slope (laws/incline.h), except for δ/r of them for a contact at depth δ in a ball.

 A solver whose ground friction is a box or a diamond brakes each component on its own, or
 the larger one first; such a motion is recognised.

 About: the box first, then its balls. Numbers: expected_box_acceleration,
 expected_ball_acceleration, expected_ball_spin_rate. */
extern const Law kRollingBox;

}  // namespace touchstone
