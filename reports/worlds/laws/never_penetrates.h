#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Bodies that collide never penetrate deeper than they can move in one step. [m]

 A contact that is first detected at the end of a step is at most V h deep, where V is the
 speed at which the surfaces approach. Gravity may add g h² before the contact resists; an
 engine need not undo that. The tolerance is 1.5 times that depth, and 64 roundings per
 step. A penetration at the start is granted. The depth is the referee's, certified.

 V is the largest speed of approach that the pair could have had since it was last apart,
 or so far if not every step is sampled. It is |v_A| + |v_B| + |ω_A| r_A + |ω_B| r_B at
 the samples, without a sphere's own spin, and what gravity adds between two samples. It
 is not |v_A − v_B|, since an impact may stop one of two bodies that fly together. For
 spheres and half-spaces |v| counts along the normal only, if every step is sampled.

 About: bodies; pairs of which at least one is named. Numbers: slack [m], granted on top,
 with its reason in the claim's `because`; parted_by [s], the time from which a
 penetration at the start is no longer granted. */
extern const Law kNeverPenetrates;

}  // namespace touchstone
