#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A point on a rod to a fixed point swings in a plane, by elliptic functions
 (truth/pendulum.h). Its period from rest at θ₀ is 4 √(L/g) K(sin² ½θ₀) (IFToMM benchmark
 A01). [m], [m/s]

 A rod that is constrained by velocities loses the power ½ m v⁴ h/L², or becomes longer.
 An engine in angles has δT/T = −h² g cos θ₀/(24 L). The tolerance is that of
 law_support/held_by_rods.h.

 About: one body, held at its centre, or one particle, moving in a vertical plane.
 Numbers: expected_period, of a swing or of one full turn. */
extern const Law kPendulum;

}  // namespace touchstone
