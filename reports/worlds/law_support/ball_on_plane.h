#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {

/** Returns the reason why body `index` is not a ball with equal moments of inertia that
 starts on a static plane; empty if it is. */
std::string WhyNoBallOnPlane(const World& world, int index);

/** The same for a ball, or for a capsule or a cylinder that lies on its side and moves
 and spins as it rolls: along the plane across its axis, and about its axis. */
std::string WhyNoRollerOnPlane(const World& world, int index);

/** Checks a ball that rolls or slips on a plane, or a roller, against its closed-form
 motion.

 Friction acts on whatever presses the contact. So a velocity may be off by (1 + μ) of the
 ball's own velocity along the normal, and by δ/r of the velocity for a contact at depth
 δ, × 1.5. The residual of the solver and rounding come on top. The tolerance of the spin
 is that of the velocity over the radius, and over k if k < 1 (I = k m r²). */
class BallOnPlane {
 public:
  /** The errors of an engine at one time, derived by the law. */
  struct Errors {
    double speed;    ///< Scale of the solver's residual and of rounding. [m/s]
    double surface;  ///< Scale of the error of a contact at depth δ. [m/s]
    double ending;   ///< Change caused by an event one step early or late. [m/s]
    double lag;      ///< Distance by which the scheme is behind or ahead. [m]
  };

  /** `how` says how the ball moves, as in "rolling it moves at". @pre
   WhyNoRollerOnPlane() is empty. */
  BallOnPlane(const Motion& motion, int body, const OnPlane& on, std::string how,
              const std::string& velocity_because, const std::string& position_because);

  /** Checks sample `s` against the motion `truth`; the orientation of `truth` is not
   read. */
  void Take(std::size_t s, const BodyState& truth, const Errors& errors);

  /** Returns the findings of position, velocity and spin. */
  std::vector<Worst> Findings() const { return {position_, velocity_, spin_}; }

 private:
  const Motion& motion_;
  int body_;
  OnPlane on_;
  std::string how_;
  Worst position_;
  Worst velocity_;
  Worst spin_;
};

}  // namespace touchstone
