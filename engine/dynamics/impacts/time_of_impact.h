#pragma once

#include <optional>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/free_flight.h"

namespace cookbook {

/** Parameters that decide whether a contact is an impact. */
struct ImpactRules {
  double h;                             ///< Time step. [s]
  double restitution_threshold_factor;  ///< See Settings.
  Gyroscopic gyroscopic;
};

/** A relative velocity below this fraction of the speeds of both bodies, by translation
 and by rotation, is treated as zero: rounding and the solver leave that much. */
inline constexpr double kRelativeSpeedTolerance = 1e-12;

/** The motion of two bodies at a contact. */
enum class ContactPhase {
  kSeparating,  ///< They move apart, or move together and no force presses them.
  kImpacting,   ///< They approach faster than the resting threshold.
  kResting,     ///< All other contacts.
};

/** Classifies the contact at `p_W`. `a_AB_W` is the acceleration of B relative to A due
 to forces; `load_acceleration` that of the pair, see ExternalLoads. The threshold between
 resting and impacting is that of ContactSolver. */
ContactPhase PhaseAt(const Eigen::Vector3d& p_W, const Eigen::Vector3d& n_AB_W,
                     const RigidBody& A, const RigidBody& B,
                     const Eigen::Vector3d& a_AB_W, double load_acceleration,
                     const ImpactRules& rules);

/** Returns the gap below which two bodies touch at their time of impact. [m] */
double ContactTolerance(const RigidBody& A, const RigidBody& B);

/** Returns the contacts of two bodies at their time of impact. */
Manifold CollideAtImpact(const RigidBody& A, const RigidBody& B);

/** Returns whether a penetration of two bodies by `distance` [m] may be so deep that
 collision detection pushes them out on the wrong side. */
bool MayTunnel(const RigidBody& A, const RigidBody& B, double distance);

/** Time of impact by conservative advancement (Mirtich 1996). Returns the first time from
 `from` [s] to the end of the step at which two bodies touch and at least one contact is
 an impact.

 Without rotation, bodies do not pass through anything that they hit. A contact below the
 impact threshold of PhaseAt() is not reported unless the bodies might tunnel.

 With rotation, the advancement is not conservative: its length follows from the support
 points that face each other, and is a quarter of a step if these do not meet or if the
 bodies touch already. If another contact of two bodies that touch is deep by then, its
 time is bisected. Otherwise a contact that rotation alone causes may be detected late,
 but before the bodies can be so deep in each other that they leave on the wrong side.
 Bounds assume the angular velocity at the start of the step. They do not hold for a body
 without symmetry that turns by tens of radians in a step: its turn is integrated too
 coarsely. */
std::optional<double> TimeOfImpact(const FreeFlight& A, const FreeFlight& B, double from,
                                   const ImpactRules& rules);

}  // namespace cookbook
