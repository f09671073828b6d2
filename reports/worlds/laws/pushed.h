#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A blow J at the point r of a body gives it the momentum J and the angular momentum r ×
 J about its centre, and gravity and its force give Δt (m g + F). [N s], [N m s]

 Held from the sample before each blow to the one after it, against the motion's own state
 before: rounding for the momentum. Angular momentum: what the gyroscopic term may lose
 between the two samples, h Δt times what laws/scheme_drift.h says, × 1.5; and where no
 sample falls on the blow, |ω| Δt |r| |J|, the body having turned by then.

 About: bodies that blows strike, and that nothing else touches or holds between those
 samples. Numbers: expected_speed_gain |J|/m and expected_spin_gain |I⁻¹ r × J|, of the
 first blow of the first body. */
extern const Law kPushed;

}  // namespace touchstone
