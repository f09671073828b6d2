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

/** One number of a world as every oracle moves it, for the eye: it decides nothing. */
struct CurveSet {
  std::string title;    ///< E.g. "y of ball".
  std::string unit;     ///< E.g. "m".
  MeasureKind measure;  ///< Whose tolerance is a band about the truth.
  /** In the order of WorldResult::trajectories; empty curves where there is no motion. */
  std::vector<Curve> of_oracle;
  std::optional<Curve> truth;  ///< Where a claim's closed form says it.
};

/** Returns the place of what the world is about, along the axis on which the first oracle
 moves it farthest; the energy; and the magnitude of the linear momentum of everything
 that moves.

 The truth of the place is the closed form of the first claim that has one; those of
 energy and, without gravity, momentum are their values at the start, where a claim says
 that they are conserved. */
std::vector<CurveSet> CurvesOf(const WorldResult& world);

}  // namespace touchstone
