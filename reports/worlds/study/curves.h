#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/study/run_worlds.h"

namespace touchstone {

/** A number over time. */
struct Curve {
  std::vector<double> times;  ///< [s]
  std::vector<double> values;
};

/** One quantity of a world over time, for every oracle. It is drawn for people to look
 at; no verdict depends on it. */
struct CurveSet {
  std::string title;    ///< E.g. "y of ball".
  std::string unit;     ///< E.g. "m".
  MeasureKind measure;  ///< Its tolerance is drawn as a band about the truth.
  /** One curve per oracle, in the order of WorldResult::trajectories. A curve is empty if
   there is no motion. */
  std::vector<Curve> of_oracle;
  std::optional<Curve> truth;  ///< Absent if no claim has a closed form for it.
};

/** Returns three or four quantities: the position of the first thing that the world's
 claims are about; how far it is from its closed form, if there is one; the energy; and
 the magnitude of the linear momentum of everything that moves. The position is given
 along the axis on which the first oracle moves the thing farthest.

 The truth of the position is the closed form of the first claim that has one. The truth
 of energy, and without gravity of momentum, is the value at the start, provided that a
 claim says that it is conserved. */
std::vector<CurveSet> CurvesOf(const WorldResult& world);

}  // namespace touchstone
