#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** In each step, a body, particle or node moves and turns at its own velocities:
 Δx = ∫ v dt and ΔR = exp ∫ ω dt, for any integrator. [m], [rad]

 A scheme moves a body by the mean of the velocities that the body has during the step.
 They start at v₀, end at v₁, and their total variation is V. So their mean Δx/h lies in
 the ellipsoid |v − v₀| + |v − v₁| ≤ V. The value is half the amount by which
 |Δx − h v₀| + |Δx − h v₁| exceeds h |v₁ − v₀|, which is 0 for velocities between v₀ and
 v₁. The tolerance is h (V − |v₁ − v₀|)/2, and what follows.

 V is the sum of the changes by loads, pushes and reported contacts, and of the part of
 v₁ − v₀ that these do not explain. Unreported causes are bounded, and the bounds are
 multiplied by four:
 - contacts of an engine that reports none, and contacts of particles. They can act twice
   in a corner, and at each of the four stages of a Runge–Kutta step;
 - the force of a rod, at most 2 E/L. E is the kinetic energy of all bodies on rods, L
   the shortest length of a rod or of its lever arm;
 - the impulse that a rod transmits if a body on a rod has a contact, at most √(2 E m).
 The forces of springs and joints are smooth, so the changes of velocity in the steps
 before and after are added to V, too.

 The tolerance contains 64 roundings. A turn by θ whose spin varies by δ/h is also granted
 θ − atan θ + θ δ: the matrix R (I + h [ω]) made orthonormal turns by atan θ; turns about
 different axes do not commute, by θ δ/4 (Magnus, 1954); and the lever arms of impulses
 and the moments of inertia turn with the body.

 Position correction changes no velocity. It moves a body by at most the sum of all
 overlaps that are linked to the body, at the start of the step or made in it. If the
 body has a joint or spring, the length errors of all rods are added. It turns a body by
 at most that sum over twice the least radius of gyration k: an impulse at the lever arm
 a that moves its own point by d turns the body by d a/(k² + a²).

 Judges only motions with a sample at every step. About: bodies, particles and cloths.
 Numbers: none. */
extern const Law kMovesAtItsVelocity;

}  // namespace touchstone
