#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Two points, one on a rod to a fixed point and the other on a rod to the first. There
 is no closed form: the truth is the motion of the constrained points, ẍ = g + M⁻¹ Jᵀ λ,
 integrated to rounding (truth/rods.h). [m], [m/s]

 The tolerance is that of law_support/held_by_rods.h. The motion is chaotic: for two rods
 of 1 m, errors grow about sixtyfold in ten seconds, and the tolerance with them.

 About: the upper, then the lower of two bodies, held at their centres, or particles.
 Numbers: until [s], the end of the judged time. */
extern const Law kDoublePendulum;

}  // namespace touchstone
