#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "reports/finding/proof.h"
#include "reports/worlds/law_support/citing.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the distance between two trajectories of the same world, for each sample that
 both have and that is before `until` [s]. It is the largest over all bodies, particles
 and nodes. For a rigid body it is the distance of the centres plus `radius` times the
 angle between the orientations. [m] */
std::vector<double> DistancesBetween(const Trajectory& a, const Trajectory& b,
                                     double radius, double until);

/** Returns the largest of DistancesBetween(): NaN if one of them is NaN, 0 if there are
 none. [m] */
double DistanceBetween(const Trajectory& a, const Trajectory& b, double radius,
                       double until);

/** Returns the largest difference before `until` [s], as ProofKind::kPlaces; `rest` is
 the angle between the orientations [rad]. kNone if the trajectories do not differ. */
Proof LargestDifference(const World& world, const Trajectory& a, const Trajectory& b,
                        double until);

/** Returns whether two states are equal in every number. −0 equals 0, and a NaN nothing.
 */
bool AreEqual(const WorldState& a, const WorldState& b);

/** Returns the first difference of two trajectories in words: the time of the sample, the
 name of the body or particle or the index of the node, the field, and both numbers. An
 empty sentence if they agree bit for bit; −0 equals 0, and a NaN equals itself. */
CitingProof FirstDifference(const World& world, const Trajectory& a, const Trajectory& b);

/** Returns the limit of the motion as the step goes to 0, by Richardson extrapolation of
 a scheme of first order: 2 x(h/2) − x(h), sample by sample. Quaternions are brought to
 the same sign first and normalised afterwards.
 @pre Both have the same samples. */
Trajectory ExtrapolatedToZeroStep(const Trajectory& coarse, const Trajectory& fine);

}  // namespace touchstone
