#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** What a body's momentum gains is what gravity, force, blows and the contacts that the
 engine reports give it: m Δv = Δt (m g + F) + Σ J. [N s]

 So says every scheme, whatever the step and however badly contacts are solved: rounding
 is all that may be off, 64 roundings a step of the sum of the sizes. An engine whose
 impulses do not balance reports others than it applied.

 Speaks only of engines that give their impulses. About: bodies that no spring or joint
 holds. Numbers: none. */
extern const Law kMomentumBalance;

}  // namespace touchstone
