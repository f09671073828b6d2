#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body that spins on a flat sole, about the normal of a level static plane, is not
 spun up, and friction slows it no faster than at the farthest point of the sole: with the
 spin ω₀ at the start, the weight m g on the plane, the inertia I about the normal and the
 distance R of that point from the vertical through the centre of mass

   ω₀ − √2 μ m g R/I t <= ω <= ω₀, and ω >= 0 in the sense of ω₀. [rad/s]

 ω is the angular momentum about the normal, n·(R I Rᵀ ω), over I: a tall body that leans
 by a documented slop spins slower about the normal and loses nothing. Or it is the spin
 about the normal, which an engine without a gyroscopic term keeps; a motion need obey one
 of the two. Where on a flat sole a rigid body presses is not determined, so neither is
 the torque. √2 is the corner of a friction cone that is a square, the widest in use. R
 includes how far the rim moves out when the body leans by what settling allows. Without
 friction the spin is constant.

 Tolerance: what settling (law_support/on_plane.h) may give or take, the spin of its
 energy or the friction of its speed at that point; the error h ω₀ of a step in what a
 body that leans as far exchanges between spin and angular momentum, |I_i/I − 1| sin²θ ω₀;
 the residual of the solver, rounding.

 About: boxes on a face and cylinders on a base that start with a spin about the normal
 alone. Numbers: none. */
extern const Law kSpinsOnPlane;

}  // namespace touchstone
