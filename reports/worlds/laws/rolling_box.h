#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A box pulled over a level plane, with balls that roll on it (SimBenchmark "rolling").
 [m/s], [rad/s]

 Balls of mass m and inertia k m r² roll without slip: each holds the box back by
 m a k/(1 + k) and moves at a k/(1 + k), so that
   a = (F − μ g (M + Σ m))/(M + Σ m k/(1 + k)),  α = a/((1 + k) r)
 along the pull, zero where friction holds it. Velocities are exact for every step, as on
 a slope (laws/incline.h), but for δ/r of them where a contact is δ inside a ball.

 A solver whose friction with the ground is a box or a diamond moves each component on its
 own, or the larger one first; it is recognised by that.

 About: the box first, then its balls. Numbers: expected_box_acceleration,
 expected_ball_acceleration, expected_ball_spin_rate. */
extern const Law kRollingBox;

}  // namespace touchstone
