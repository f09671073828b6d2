#pragma once

#include <string_view>

#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/rounding_growth.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** Returns the words for how a variant differs from its world, e.g. "mirrored". */
std::string_view ChangeOf(MeasureKind measure);

/** Judges the motion of a variant against the motion of the world itself.
 `seen_in_world` is the variant's motion mapped back into the world. Both motions
 approximate the same one, so they may differ by the sum of three terms: their
 discretisation errors, 2 |x(h) − x(h/2)| each for a scheme of first order; rounding,
 amplified by the motion; and in a stable world, events that come a step late.

 The tolerance uses the amplification of rounding before the horizon of `growth`. After
 the horizon a larger difference is `undecidable` as long as amplified rounding explains
 it, and a failure beyond that.
 @pre study.half is set; both trajectories are answered and did not diverge. */
Finding JudgeVariant(const Study& study, const RoundingGrowth& growth,
                     MeasureKind measure, const Trajectory& seen_in_world);

}  // namespace touchstone
