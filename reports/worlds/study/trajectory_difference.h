#pragma once

#include <string>
#include <vector>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the largest distance between the places of one thing in two trajectories of
 the same bodies, for each sample that both have and that is before `until` [s]: rigid
 bodies by their centres plus `radius` times their angle to each other, particles and
 nodes as points. [m] */
std::vector<double> DistancesBetween(const Trajectory& a, const Trajectory& b,
                                     double radius, double until);

/** Returns the largest of DistancesBetween(): a NaN where there is one, 0 of none. [m] */
double DistanceBetween(const Trajectory& a, const Trajectory& b, double radius,
                       double until);

/** Says where they are farthest from each other, before `until`: "at 0.32 s lid is at
 (0, 1, 0) and (0, 1.5, 0)", with the angle between them where the bodies turn. Empty
 where they are nowhere apart. */
std::string LargestDifference(const World& world, const Trajectory& a,
                              const Trajectory& b, double until);

/** Returns whether two trajectories are the same bit for bit; −0 equals 0, NaN itself. */
bool AreIdentical(const Trajectory& a, const Trajectory& b);

/** Says where two trajectories that are not identical first differ: the sample's time,
 which body, particle or node by its index, and which field. */
std::string FirstDifference(const Trajectory& a, const Trajectory& b);

/** Returns the limit of the motion for a step that goes to 0, by Richardson's
 extrapolation of a scheme of first order: 2 x(h/2) − x(h), sample by sample; orientations
 are added with equal signs and normalised.
 @pre Both have the same samples. */
Trajectory ExtrapolatedToZeroStep(const Trajectory& coarse, const Trajectory& fine);

}  // namespace touchstone
