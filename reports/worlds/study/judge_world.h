#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/worlds/law_support/law.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** Judges the trajectory by every claim of the scenario, by every universal law that it
 does not claim (UniversalClaims()) and by its plain expectations. Returns one finding per
 claim and measure, in that order. A trajectory fails `answering` and is judged no
 further if it diverged, crashed or timed out, or if it does not start in the state that
 the world gives. If the motions at half and a quarter of the step are available:

 - a failure has the cause `discretisation` if its value falls to at most 1/√2 at each
   halving of the step, else the cause `defect`;
 - smooth laws are also judged on the order of convergence and on the limit, and laws with
   impacts on the motion at a quarter of the step.

 No pass is wider than its FineTolerance. */
std::vector<Finding> JudgeWorld(const Study& study);

/** Sorts findings by measure, and keeps the order of those with the same measure. */
void SortByMeasure(std::vector<Finding>& findings);

/** Returns the same findings in groups: first answering, then one group per claim, per
 universal law and per expectation. */
std::vector<std::vector<Finding>> JudgeWorldByClaim(const Study& study);

/** Returns the `answering` finding of `other`, a motion of a changed world with steps of
 `dt` [s]. `asked` names the change, e.g. "at half the step" or "mirrored". Empty if the
 oracle answered or does not support that world. */
std::optional<Finding> FailureToAnswer(const Study& study, const Trajectory& other,
                                       std::string_view asked, double dt);

/** Judges whether a second run of the same world gives the same bits. */
Finding JudgeRepetition(const Study& study, const Trajectory& again);

/** Returns what an engine printed while it ran, as the end of a sentence: " (it printed:
 LCP internal error)". Empty if it printed nothing. */
std::string PrintedBy(const Trajectory& trajectory);

/** Returns whether the trajectory reached the end of its world. */
bool IsWhole(const Trajectory& trajectory);

}  // namespace touchstone
