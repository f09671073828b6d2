#pragma once

#include <span>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Of a quantity over the members of an ensemble. */
struct Statistic {
  double mean = 0;
  double deviation = 0;  ///< Of a member, estimated: √(Σ (x − mean)² / (members − 1)).
};

/** What can be compared of a motion that is chaotic: no member, but what all of them have
 in common at the end. */
struct EnsembleStatistics {
  int members = 0;  ///< 0: there is no ensemble, or not every member was answered.
  Statistic kinetic_energy;  ///< [J]
  Statistic height;          ///< Of the common centre of mass, against gravity. [m]
  /** Root mean square distance from the common centre of mass, by mass. [m] */
  Statistic width;
};

/** Returns the statistics of `motions`, one of each member; `world` is any of the
 members. No members where one of the motions is not whole or where nothing moves. */
EnsembleStatistics StatisticsOf(const World& world, std::span<const Trajectory> motions);

/** Returns whether the means differ by more than chance explains in all but one of a
 thousand cases, by Welch's t-test (Biometrika 34, 1947), and by more than rounding, 1e-9
 of them.
 @pre Both are of at least 2 members. */
bool Differ(const Statistic& a, int members_a, const Statistic& b, int members_b);

}  // namespace touchstone
