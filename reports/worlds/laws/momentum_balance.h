#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body's momentum changes by gravity, its force, pushes and the contact impulses that
 the engine reports: m Δv = Δt (m g + F) + Σ J. [N s]

 Every scheme satisfies that, for any step and however badly contacts are solved. So the
 tolerance is rounding alone: 64 roundings per step of the sum of the magnitudes;
 SolverRoundingOf() of the impulses on the body for each contact of a step, or of all
 impulses of the step if that is more, since a cost is one of all of them; and the
 momentum of NoiseOfPositions(). An engine whose impulses do not balance reports others
 than it applied.

 Judges only engines that report contact impulses. About: bodies that no spring or joint
 holds. Numbers: none. */
extern const Law kMomentumBalance;

}  // namespace touchstone
