#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Bodies that collide are never deeper in each other than a step can take them. [m]

 A contact that is first seen at the end of a step is at most V h deep, V being the speed
 at which the surfaces approach, and gravity may add g h² before it is resisted; an engine
 need not undo that. V is the largest speed of approach the pair could have had so far:
 |v_A| + |v_B| + |ω_A| r_A + |ω_B| r_B, a sphere's own spin aside, at the samples, and
 what gravity adds between two of them; not |v_A − v_B|, since a blow may stop either of
 two that fly together. × 1.5, and 64 roundings a step. A depth of the start is granted.
 The depth is the referee's, certified.

 About: bodies; pairs of which at least one is named. Numbers: slack [m], granted on top;
 the claim's `because` says why; parted_by [s], from when on what overlapped at the start
 is granted no more. */
extern const Law kNeverPenetrates;

}  // namespace touchstone
