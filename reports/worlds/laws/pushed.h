#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A push J at the point r of a body gives it the momentum J and the angular momentum r ×
 J about its centre; gravity and its force give Δt (m g + F). [N s], [N m s]

 Judged from the sample before each push to the one after it, relative to the motion's own
 state before. Tolerance of the momentum: rounding. Tolerance of the angular momentum:
 what the gyroscopic term may lose between the two samples, h Δt times the rate in
 law_support/scheme_drift.h, × 1.5; and, if no sample falls on the push, |ω| Δt |r| |J|,
 since the body has turned by then.

 About: bodies with pushes that nothing else touches or holds between those samples.
 Numbers: expected_speed_gain |J|/m and expected_spin_gain |I⁻¹ r × J|, of the first push
 of the first body. */
extern const Law kPushed;

}  // namespace touchstone
