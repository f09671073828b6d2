#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Bodies that collide never pass through each other. [m]

 Two bodies that are apart at two samples have moved around each other. The volume
 that A sweeps on the straight way from one to the other, seen from B, may overlap with B
 only as deep as the true way may have left the straight one. Samples between the two at
 which they overlap are left out: a body that is pushed out on the far side has passed
 through.

 A way that changes its velocity by Δv in the time Δt leaves its chord by at most ¼ Δv Δt,
 and a constant acceleration a adds ⅛ a Δt². Δv is the change beyond the loads, or the sum
 of the reported impulses over the mass if that is more. No way leaves its chord by more
 than half its length, at speeds that the truth allows (law_support/allowed_motion.h). The
 tolerance is 1.5 times that, with the bend by rotation (law_support/swept.h), and 64
 roundings per step. A body in free flight is so judged exactly, whatever its step.

 The depth is the referee's, certified: the least distance by which the sweeping body
 would have had to leave its way. Half-spaces are left out, since nothing is on their
 other side: never_penetrates sees a body inside.

 About: bodies; pairs of which at least one is named. Numbers: none. */
extern const Law kNeverPassesThrough;

}  // namespace touchstone
