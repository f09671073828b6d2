#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Bodies that collide never pass through each other. [m]

 Two bodies that are apart at two samples have moved around each other. The volume
 that A sweeps along the chord of its path relative to B may overlap with B only as deep
 as the path may have left the chord. Samples between the two at
 which they overlap are left out: a body that is pushed out on the far side has passed
 through.

 A path on which the velocity changes by Δv in the time Δt leaves its chord by at most
 ¼ Δv Δt, and a constant acceleration a adds ⅛ a Δt². Δv is the change beyond the loads,
 or the sum of the reported impulses over the mass if that is more. No path leaves its
 chord by more than half its length, at speeds that the truth allows
 (law_support/allowed_motion.h). The tolerance is 1.5 times that, with the deviation by
 rotation (law_support/swept.h), and 64 roundings per step. A body without impulses,
 loads and rotation has only the roundings, whatever its step.

 The depth is the referee's, certified: the least distance by which the sweeping body
 would have had to leave its path. Half-spaces are left out, since nothing is on their
 other side: never_penetrates sees a body inside.

 About: bodies; pairs of which at least one is named. Numbers: none. */
extern const Law kNeverPassesThrough;

}  // namespace touchstone
