#pragma once

#include <string_view>

#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/rounding_growth.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** Returns how a variant differs from its world: "mirrored", … */
std::string_view ChangeOf(MeasureKind measure);

/** Judges the motion of a variant, as seen in the world, against the motion of the world:
 both are approximations of one motion, so they may differ by the sum of their
 discretisation errors, 2 |x(h) − x(h/2)| each for a scheme of first order, and by
 rounding, as much of it as the motion makes, and in a stable world by what comes late.

 From the horizon of `growth` on nothing is granted for rounding beyond what the motion
 made of it before; what differs by more there, but not by more than rounding explains, is
 `undecidable`.
 @pre study.half is there; both trajectories are answered and did not diverge. */
Finding JudgeVariant(const Study& study, const RoundingGrowth& growth,
                     MeasureKind measure, const Trajectory& seen_in_world);

}  // namespace touchstone
