#pragma once

#include <span>

#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** Returns the distance by which two motions of a stable world may differ because an
 event falls into one step or the next. A body that starts a rounding error away from a
 contact may touch only in the next step. Until then everything continues to move, by
 V h, and brakes that much later; and each body of a stack falls by up to 2 g h². The sum
 is taken 1.5 times. [m] */
double LatenessOf(const Study& study);

/** Judges a world that its author claims to be stable: a change of its start is amplified
 at most `gain` times. `nudged` are motions of the same world with the start moved by the
 rounding error of one step. The engine's motion must be as stable, apart from
 LatenessOf(). Returns one finding, that of the worst motion.
 @pre All motions are answered and did not diverge. */
Finding JudgeStability(const Study& study, double gain,
                       std::span<const Trajectory> nudged);

}  // namespace touchstone
