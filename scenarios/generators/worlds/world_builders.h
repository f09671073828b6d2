#pragma once

#include "scenarios/generators/worlds/world_draw.h"

namespace touchstone {

// One random world each, with z up. The comment of each names what it claims.

/** A sphere or a flat box falls straight down: bounce_series. */
WorldScenario StraightDrop(WorldDraw& draw);
/** A box or a sphere falls at any attitude, moving and turning: coulomb_cone. */
WorldScenario TumblingDrop(WorldDraw& draw);

/** Two spheres hit each other: sphere_impact. */
WorldScenario SpherePair(WorldDraw& draw);
/** A sphere hits the ground at an angle: sphere_impact. */
WorldScenario SphereOnPlane(WorldDraw& draw);
/** A corner, or with friction an edge, of a box hits the ground: corner_impact. */
WorldScenario BoxOnPlane(WorldDraw& draw);

/** A box or a sphere on a slope, from rest: incline. */
WorldScenario FromRestOnSlope(WorldDraw& draw);
/** A box slides to a stop: slide_to_stop. */
WorldScenario SlidingBox(WorldDraw& draw);
/** A sphere slips until it rolls: slip_to_roll. */
WorldScenario SlippingSphere(WorldDraw& draw);
/** A sphere rolls on a slope: rolls. */
WorldScenario RollingSphere(WorldDraw& draw);

/** A body or a particle on a rod: pendulum, joint_length. */
WorldScenario Pendulum(WorldDraw& draw);
/** Two masses on two rods: joint_length; pendulum unless the lower one is more
 than ten times as heavy. */
WorldScenario DoublePendulum(WorldDraw& draw);
/** One or two bars that hang by rods at their ends: joint_length, conserves_energy. */
WorldScenario HangingBars(WorldDraw& draw);

/** Two to six spheres, boxes and bars, on rods that form trees and loops and may hold
 them to the world, are thrown at the ground; one may be loose and hits them:
 joint_length. */
WorldScenario Linkage(WorldDraw& draw);

/** Two to four boxes, bars and plates fly at the first, which may be fixed: coulomb_cone,
 or conserves_momentum if nothing acts from outside. */
WorldScenario Bars(WorldDraw& draw);

/** `height` boxes at rest on each other: rests, stack_support. */
WorldScenario Stack(WorldDraw& draw, int height);

/** A box in free flight: ballistic, torque_free. */
WorldScenario FreeFlight(WorldDraw& draw);

}  // namespace touchstone
