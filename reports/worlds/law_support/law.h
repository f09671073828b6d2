#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "reports/finding/tolerance.h"
#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A trajectory, and what it takes to hold it against a law. */
struct Motion {
  const World& world;
  const OracleInfo& oracle;
  const Trajectory& trajectory;  ///< Answered; its samples end early where it diverged.
};

/** One number of a motion, held against a law. */
struct LawFinding {
  MeasureKind measure;
  double value = 0;
  Tolerance tolerance;  ///< Derived: rounding, or the error law of the step.
  /** "drop says y = 0.493 of ball at 1.2 s; ½ g t² from 1 m says 0.5": why the value is
   what it is. Shown where it exceeds the tolerance, and with `recognised`. */
  std::string proof;
  /** The legal model that the motion follows to within its own closed form, where that is
   not the truth's: "L∞ friction cone", "reflects the velocity after gravity". Its finding
   does not fail: its cause is `model`. Empty: none. */
  std::string recognised;
};

/** A statement about worlds that can be held against any motion. Laws are pure; what they
 predict comes from the world and the claim, never from an engine. */
struct Law {
  std::string_view name;           ///< As in files, e.g. "ballistic".
  std::string_view documentation;  ///< One line: what it says, what the claim must name.
  /** The numbers that a claim may state, sorted: "expected_…" is what its author derived,
   which faults() checks; the others the law reads. */
  std::span<const std::string_view> numbers;
  /** Returns what keeps `claim` from applying to `world`, e.g. a body that is no sphere;
   `where` starts with "about" or "numbers". Empty where it applies. */
  std::vector<Fault> (*faults)(const World& world, const Claim& claim);
  /** Returns one finding a measure. @pre faults() is empty. */
  std::vector<LawFinding> (*judge)(const Motion& motion, const Claim& claim);
  /** The motion it speaks of has no events and no thresholds, so that it converges at the
   order of the engine's scheme as the step goes to 0: the order and the limit are judged
   too. */
  bool smooth = false;
  /** Returns where by the closed form the centre of the first thing that the claim is
   about is at `t` [s], for the eye; null where the law says no place. World frame. [m] */
  Eigen::Vector3d (*place)(const World& world, const Claim& claim, double t) = nullptr;
  /** The motion it speaks of has impacts, which fall anywhere in their steps: by chance
   half the step moves it less or more, so that three steps show no order. Its tolerance
   falls with the step all the same: of the order and the limit is judged that the places
   at a quarter of the step are within that of a quarter of the step. */
  bool has_impacts = false;
};

/** Returns every law, sorted by name. */
std::span<const Law> Laws();

/** Returns the law of that name, or null. */
const Law* FindLaw(std::string_view name);

}  // namespace touchstone
