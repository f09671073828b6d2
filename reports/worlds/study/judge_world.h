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

/** Holds the trajectory against every claim of the scenario: one finding a claim and
 measure, in the order of the claims. A trajectory that diverged, crashed or never ended,
 or that does not start in the state that the world gives, fails `answering` and is judged
 no further. Where half and quarter steps are there:

 - what fails at dt and shrinks with it as a first power or faster has the cause
   `discretisation`; what does not shrink, `defect`;
 - of smooth laws the order of convergence and the limit are judged too, and of laws
   with impacts the motion at a quarter of the step. */
std::vector<Finding> JudgeWorld(const Study& study);

/** Returns the same findings in groups: those of answering, then those of each claim. */
std::vector<std::vector<Finding>> JudgeWorldByClaim(const Study& study);

/** Returns the `answering` finding of a motion of the same world `asked` otherwise, e.g.
 "at half the step" or "mirrored", with steps of `dt` [s]: empty where it answered or does
 not support that. */
std::optional<Finding> FailureToAnswer(const Study& study, const Trajectory& other,
                                       std::string_view asked, double dt);

/** Judges a second run of the same world: bit for bit. */
Finding JudgeRepetition(const Study& study, const Trajectory& again);

/** Returns what an engine printed as it ran, for the end of a sentence: " (it printed:
 LCP internal error)"; empty where it printed nothing. */
std::string PrintedBy(const Trajectory& trajectory);

/** Returns whether the trajectory reached the end of its world. */
bool IsWhole(const Trajectory& trajectory);

}  // namespace touchstone
