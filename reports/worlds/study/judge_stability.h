#pragma once

#include <span>

#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** Returns how far apart two motions of a stable world may come because an event falls
 into one step or the next: what starts a rounding off a contact may not be seen to touch
 until the step after. Until then all goes on as it moves, V h, and brakes later by that
 way; and of what lies on each other each falls by up to 2 g h². Times 1.5. [m] */
double LatenessOf(const Study& study);

/** Judges `nudged`, motions of the same world whose start is moved by the rounding of a
 step: of a world of which its author knows that it ends at most `gain` times as far away
 as its start was moved, the steps of one engine do too, but for LatenessOf(). One
 finding, of the worst.
 @pre All are answered and did not diverge. */
Finding JudgeStability(const Study& study, double gain,
                       std::span<const Trajectory> nudged);

}  // namespace touchstone
