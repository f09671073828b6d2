#pragma once

#include <optional>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/free_flight.h"

namespace cookbook {

/** When a meeting of two bodies is a impact. */
struct ImpactRules {
  double h;              ///< Of the step. [s]
  double resting_speed;  ///< As Settings.
  Gyroscopic gyroscopic;
};

/** Bodies that approach by less than this share of their speeds go together: what
 rounding and the solver leave. */
inline constexpr double kTogether = 1e-12;

/** What becomes of two bodies at a contact. */
enum class ContactPhase {
  kSeparating,  ///< They go apart, or together with nothing that presses them.
  kImpacting,   ///< They come faster than those that rest.
  kResting,     ///< Anything else.
};

/** Returns what two bodies make of their contact at `p_W`, given how forces change the
 velocity of B against A, and how hard they are pulled, see ExternalLoads. The threshold
 is that of ContactSolver. */
ContactPhase PhaseAt(const Eigen::Vector3d& p_W, const Eigen::Vector3d& n_AB_W,
                     const RigidBody& A, const RigidBody& B,
                     const Eigen::Vector3d& a_AB_W, double load,
                     const ImpactRules& rules);

/** Returns the gap below which two bodies touch in a impact. [m] */
double TouchOf(const RigidBody& A, const RigidBody& B);

/** Returns how two bodies touch that TimeOfImpact() brought together. */
Manifold CollideAtImpact(const RigidBody& A, const RigidBody& B);

/** Returns whether two bodies that go `way` [m] into each other may be deeper than can be
 told which way they came. */
bool MayGoThrough(const RigidBody& A, const RigidBody& B, double way);

/** Returns when, from `from` [s] to the end of the step, two bodies first touch where one
 contact at least strikes. They are found to touch by conservative advancement (Mirtich
 1996). Where neither turns, nothing is gone through that is struck; what comes no faster
 than PhaseAt() asks of a impact is not, unless it might go through. Where one turns, the
 points that face each other decide how long not to look, at most a quarter of the step:
 what only the turn brings together may be seen by so much too late, or, where it is
 thinner than that way, not at all. Bounds take the turning as fast as it is when the step
 begins. */
std::optional<double> TimeOfImpact(const FreeFlight& A, const FreeFlight& B, double from,
                                   const ImpactRules& rules);

}  // namespace cookbook
