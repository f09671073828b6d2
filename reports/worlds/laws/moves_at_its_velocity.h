#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** In each step a thing moves and turns at the velocities that it has: Δx = ∫ v dt and
 ΔR = exp ∫ ω dt, for any integrator. [m], [rad]

 A scheme moves a thing by the mean of the velocities that it passes through in a step.
 They start at v₀, end at v₁ and vary by V in all, so each of them, and hence their mean
 Δx/h, lies in the ellipsoid |v − v₀| + |v − v₁| ≤ V. The value is half of what
 |Δx − h v₀| + |Δx − h v₁| exceeds h V by: no place within that of Δx is allowed. V is the
 variation by loads, pushes and the reported contacts, and what they leave unexplained of
 v₁ − v₀. What nobody reports is granted four times where it may be: contacts, which act
 twice in a corner and at each evaluation of Runge and Kutta; and the forces of rods, at
 most 2 E/L for the kinetic energy E of all that rods hold and the shortest length L of a
 rod or its lever, as well as the impulses that rods pass on, at most √(2 E m) if anything
 touches what they hold. Springs and joints pull smoothly, so what they hold is granted
 the changes of its velocity in the steps before and after, too.

 The tolerance is 64 roundings, and of a turn by θ that varies by δ in its step also
 θ − atan θ + θ δ. The matrix R (I + h [ω]) made orthonormal turns by atan θ. Turns about
 different axes do not commute, by θ δ/4 (Magnus, 1954), and the arms of impulses and the
 moments of inertia turn with the body, so that each change of spin is known to θ of it.
 Turns whose tolerance is half a turn are left out.

 A correction of positions changes no velocity. It moves a body by no more than the sum of
 all overlaps that are linked to it, at the start of the step or made by it, and of the
 errors of all rods if one holds it; and turns it by no more than that over twice the
 least radius of gyration k: an impulse at the arm a that moves its own point by d turns
 the body by d a/(k² + a²).

 About: whatever moves. Numbers: none. */
extern const Law kMovesAtItsVelocity;

}  // namespace touchstone
