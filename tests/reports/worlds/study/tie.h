#pragma once

#include <cstddef>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns a world of a ball and a post that touch nothing. The ball is within 1 m of the
 post at the end of step 64 by less than a rounding. */
WorldScenario Tie();

/** Returns the index of the ball of Tie(), or of a variant of it. */
std::size_t BallOf(const World& world);

/** Returns the motion of a ball that turns back at the end of the step in which it is
 within 1 m of the post. In Tie() it turns back at step 64 or at the next one: half a
 metre each second apart. */
Trajectory TurnsBackNear(const World& world);

}  // namespace touchstone
