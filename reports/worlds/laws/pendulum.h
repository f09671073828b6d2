#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A point on a rod to a fixed place swings in a plane, by elliptic functions
 (truth/pendulum.h): period 4 √(L/g) K(sin² ½θ₀) from rest at θ₀ (IFToMM benchmark A01).
 [m], [m/s]

 Keeping a rod by velocities loses ½ m v⁴ h/L² of power, or lengthens it; an engine in
 angles has δT/T = −h² g cos θ₀/(24 L). The tolerance is that of laws/held_by_rods.h.

 About: one body, held at its centre, or one particle, moving in an upright plane.
 Numbers: expected_period, or the time of one turn. */
extern const Law kPendulum;

}  // namespace touchstone
