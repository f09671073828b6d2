#pragma once

#include <optional>

#include "engine/dynamics/body/free_flight.h"
#include "engine/collision/manifold.h"

namespace cookbook {

/** When a meeting of two bodies is a blow. */
struct BlowRules {
  double h;              ///< Of the step. [s]
  double resting_speed;  ///< As Settings.
  Gyroscopic gyroscopic;
};

/** Bodies that approach by less than this share of their speeds go together: what
 rounding and the solver leave. */
inline constexpr double kTogether = 1e-12;

/** What becomes of two bodies at a contact. */
enum class Meeting {
  kParts,    ///< They go apart, or together with nothing that presses them.
  kStrikes,  ///< They come faster than those that rest.
  kHolds,    ///< Anything else.
};

/** Returns what two bodies make of their contact at `p_W`, given how forces change the
 velocity of B against A, and how hard they are pulled, see Pulls. The threshold
 is that of ContactSolver. */
Meeting MeetingAt(const Eigen::Vector3d& p_W, const Eigen::Vector3d& n_AB_W,
                  const RigidBody& A, const RigidBody& B, const Eigen::Vector3d& a_AB_W,
                  double pull, const BlowRules& rules);

/** Returns the gap below which two bodies touch in a blow. [m] */
double TouchOf(const RigidBody& A, const RigidBody& B);

/** Returns how two bodies touch that FirstBlow() brought together. */
Manifold CollideAtBlow(const RigidBody& A, const RigidBody& B);

/** Returns whether two bodies that go `way` [m] into each other may be deeper than can be
 told which way they came. */
bool MayGoThrough(const RigidBody& A, const RigidBody& B, double way);

/** Returns when, from `from` [s] to the end of the step, two bodies first touch where one
 contact at least strikes. They are found to touch by conservative advancement (Mirtich
 1996). Where neither turns, nothing is gone through that is struck; what comes no faster
 than MeetingAt() asks of a blow is not, unless it might go through. Where one turns, the
 points that face each other decide how long not to look, at most a quarter of the step:
 what only the turn brings together may be seen by so much too late, or, where it is
 thinner than that way, not at all. Bounds take the turning as fast as it is when the step
 begins. */
std::optional<double> FirstBlow(const BodyFlight& A, const BodyFlight& B, double from,
                                const BlowRules& rules);

}  // namespace cookbook
