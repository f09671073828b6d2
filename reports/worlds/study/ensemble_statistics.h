#pragma once

#include <span>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Mean and standard deviation of a quantity over the members of an ensemble. */
struct Statistic {
  double mean = 0;
  double deviation = 0;  ///< Sample standard deviation: √(Σ (x − mean)² / (members − 1)).
};

/** Statistics of the final states of an ensemble. If a motion is chaotic, single members
 cannot be compared between engines, but these statistics can. */
struct EnsembleStatistics {
  int members = 0;  ///< 0 if there is no ensemble or not every member was answered.
  Statistic kinetic_energy;  ///< [J]
  Statistic height;          ///< Height of the centre of mass, against gravity. [m]
  /** Root mean square distance from the common centre of mass, weighted by mass. [m] */
  Statistic width;
};

/** Returns the statistics of `motions`, one per member; `world` is the world of any
 member. The result has 0 members if there are fewer than two motions, if one of them is
 not whole, or if nothing moves. */
EnsembleStatistics StatisticsOf(const World& world, std::span<const Trajectory> motions);

/** Returns whether the two means differ significantly: by Welch's t-test (Biometrika 34,
 1947) at a two-sided level of 1 in 1000, and by more than rounding, 1e-9 of the larger
 mean.
 @pre Both have at least 2 members. */
bool Differ(const Statistic& a, int members_a, const Statistic& b, int members_b);

}  // namespace touchstone
