#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "reports/finding/cited.h"
#include "reports/finding/finding.h"
#include "reports/finding/tolerance.h"
#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A trajectory together with the world and the oracle that a law needs to judge it. */
struct Motion {
  const World& world;
  const OracleInfo& oracle;
  const Trajectory& trajectory;  ///< Answered; its samples end early if it diverged.
};

/** The errors that a tolerance of a law grants. */
enum class Grants {
  kRounding,  ///< Rounding alone, whatever the step.
  kSolver,    ///< Rounding, and the residual of a solver.
  kStep,      ///< The error law of the step too, with the factor of safety kSafety.
};

/** A value that is within its tolerance. */
struct Within {
  double value = 0;      ///< [unit of the measure]
  double tolerance = 0;  ///< [unit of the measure]
};

/** An integration scheme, and the distance of a motion from the closed form of the
 scheme. The error of a motion that follows a scheme is known. */
struct NearestScheme {
  std::string_view name;  ///< "semi-implicit Euler"; empty: none is known.
  double error = 0;       ///< The largest at any sample. [unit of the measure]
};

/** The worst number of one measure of a motion, judged by a law. */
struct LawFinding {
  MeasureKind measure;
  double value = 0;
  Tolerance tolerance;  ///< Derived from rounding or from the error law of the step.
  Grants grants = Grants::kStep;
  /** The largest of all numbers that are within their own tolerances. It need not be the
   worst one, since tolerances differ; and it may be too large to be called right. */
  Within largest;
  /** The reason for the value: "drop says y = 0.493 of ball at 1.2 s; ½ g t² from 1 m
   says 0.5". Shown if the value exceeds the tolerance, and with `recognised`. */
  std::string proof;
  /** The legal model that the motion follows to within that model's own closed form, if
   it is not the model of the truth: "L∞ friction cone", "reflects the velocity after
   gravity". The finding then does not fail, and its cause is `model`. Empty: none. */
  std::string recognised;
  /** The scheme of integration whose own closed form is nearest to the motion. */
  NearestScheme scheme;
  /** The parts of the world that `proof` names; `time` is the sample of the value. */
  Cited cited;
};

/** Returns whether the value is beyond its tolerance; a NaN of either counts as beyond.
 */
inline bool IsBeyond(const LawFinding& finding) {
  return !(finding.value <= finding.tolerance.value);
}

/** A statement about worlds that any motion can be judged by. Laws are pure: their
 predictions come from the world and the claim, never from an engine. */
struct Law {
  std::string_view name;  ///< The name in scenario files, e.g. "ballistic".
  /** Older names, of laws that have become cases of this one. Files may use them. */
  std::span<const std::string_view> aliases = {};
  /** One line: the statement, and the names the claim must give. */
  std::string_view documentation;
  /** The numbers that a claim may state, sorted. A number "expected_…" is derived by the
   claim's author and checked by faults(); the law reads the others. */
  std::span<const std::string_view> numbers = {};
  /** Returns the reasons why `claim` does not apply to `world`, e.g. a body that is no
   sphere. `where` of a fault starts with "about" or "numbers". Empty if the claim
   applies. */
  std::vector<Fault> (*faults)(const World& world, const Claim& claim);
  /** Returns one finding per measure. @pre faults() is empty. */
  std::vector<LawFinding> (*judge)(const Motion& motion, const Claim& claim);
  /** Whether the motion has no events and no thresholds. Such a motion converges at the
   order of the engine's scheme as the step goes to 0, so the order and the limit are
   judged too. */
  bool smooth = false;
  /** Returns the predicted positions of the centre of the claim's first subject, at those
   of `times` [s], ascending, at which the claim is judged: the first ones. Null if the
   law predicts no position. World frame. [m] @pre faults() is empty. */
  std::vector<Eigen::Vector3d> (*places)(const World& world, const Claim& claim,
                                         const std::vector<double>& times) = nullptr;
  /** Whether the motion has impacts. They fall anywhere within their steps: halving the
   step may change the motion more or less by chance, so three steps show no order. The
   tolerance still falls with the step. So instead of the order and the limit, the
   positions at a quarter of the step are judged by the tolerance at a quarter of the
   step. */
  bool has_impacts = false;
  /** Returns the claim by which every motion of `world` is judged, although no file
   states it; empty if the law does not apply to the world. A claim that names its
   subjects is about each of them by itself. Null if the law is not universal: a file
   claims it. */
  std::optional<Claim> (*universal)(const World& world) = nullptr;
  /** Whether the law sees more if there is a sample at every step: it then judges the
   motion with those, if somebody took them. */
  bool of_steps = false;
};

}  // namespace touchstone
