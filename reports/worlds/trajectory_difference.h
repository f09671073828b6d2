#pragma once

#include <string>

#include "oracles/trajectory.h"

namespace touchstone {

/** Returns the largest distance between the places of one thing at one time in two
 trajectories of the same bodies: rigid bodies by their centres plus `radius` times their
 angle to each other, particles and nodes as points; over the samples that both have and
 that are before `until` [s]. [m] */
double DistanceBetween(const Trajectory& a, const Trajectory& b, double radius,
                       double until);

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
