#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding.h"
#include "reports/worlds/law.h"
#include "reports/worlds/world_variants.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** How one oracle moves one world, at the step that the world asks for and, where they
 were simulated, at a half and a quarter of it. */
struct Study {
  const WorldScenario& scenario;
  const OracleInfo& oracle;
  const Trajectory& trajectory;
  const Trajectory* half = nullptr;
  const Trajectory* quarter = nullptr;
  /** How many times as far the motion ends as its start was moved by a rounding; >= 1. */
  double gain = 1;
};

/** Holds the trajectory against every claim of the scenario: one finding a claim and
 measure, in the order of the claims. A trajectory that diverged, crashed or never ended,
 or that does not start in the state that the world gives, fails `answering` and is judged
 no further. Where half and quarter steps are there:

 - what fails at dt and shrinks with it as a first power or faster has the cause
   `discretisation`; what does not shrink, `defect`;
 - of smooth laws the order of convergence and the limit are judged too. */
std::vector<Finding> JudgeWorld(const Study& study);

/** Returns the same findings in groups: those of answering, then those of each claim. */
std::vector<std::vector<Finding>> JudgeWorldByClaim(const Study& study);

/** Returns the `answering` finding of a motion of the same world `asked` otherwise, e.g.
 "at half the step" or "mirrored", with steps of `dt` [s]: empty where it answered or does
 not support that. */
std::optional<Finding> FailureToAnswer(const Study& study, const Trajectory& other,
                                       std::string_view asked, double dt);

/** Returns how a variant differs from its world: "mirrored", … */
std::string_view ChangeOf(MeasureKind measure);

/** Judges the motion of a variant, as seen in the world, against the motion of the world:
 both are approximations of one motion, so they may differ by the sum of their
 discretisation errors, 2 |x(h) − x(h/2)| each for a scheme of first order, and by
 rounding, as much of it as the motion makes.
 @pre study.half is there; both trajectories are answered and did not diverge. */
Finding JudgeVariant(const Study& study, MeasureKind measure,
                     const Trajectory& seen_in_world);

/** Judges a second run of the same world: bit for bit. */
Finding JudgeRepetition(const Study& study, const Trajectory& again);

/** Returns what an engine printed as it ran, for the end of a sentence: " (it printed:
 LCP internal error)"; empty where it printed nothing. */
std::string PrintedBy(const Trajectory& trajectory);

/** Returns whether the trajectory reached the end of its world. */
bool IsWhole(const Trajectory& trajectory);

}  // namespace touchstone
