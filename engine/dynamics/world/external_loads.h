#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/joints/distance_joint.h"
#include "engine/dynamics/joints/spring.h"
#include "engine/dynamics/solver/union_find.h"

namespace cookbook {

/** The load accelerations of the bodies, and the thresholds of rest that follow from
 them: speculative margin, slop, and the speed below which a contact does not bounce.
 Box2D uses constants for
 them. Here they scale with the loads, so that bodies at rest under forces or springs
 behave like bodies at rest under gravity.

 The load acceleration of a body is the acceleration that external loads would cause if
 nothing held it,

   a = max(|g + F/m| + |τ|/(m r), |S|/m),

 with the forces F and torques τ on it, the sum S of its spring forces and its bounding
 radius r. So gravity and a constant force that cause the same motion have the same load
 acceleration. It is zero for a body in free fall in its own frame, but not for a body
 that hangs on a spring. A torque counts like a force with the lever arm r. Points have no
 contact constraints, and the springs on them are left out.

 Contacts, joints and springs transmit loads. An island is what they joined in the
 previous step, without static bodies; ContactSolver's islands are joined by contacts
 alone. Its load acceleration is

   ā = Σ m a / Σ m,

 the gravity under which the island would weigh as much as its loads. The mean is weighted
 by mass, so that a light body under a great force affects the island only as much as it
 can. It is a mean over the island and not over the world, because other islands are not
 affected.

 Speculative margin and slop are 2 ā h². Where forces load more than gravity does, they
 are at most the greater of 2 |g| h² and a fiftieth of the inner radius of the body: a
 small body may be pressed as in a vice. A pair uses the smaller value of its bodies.

 A contact does not bounce if its approach speed is below

   (h a + |(u_f − u₀)·n|) · Settings::restitution_threshold_factor,

 with the greater a of its bodies, the relative velocity u₀ before the step and u_f at its
 end without impulses. On a floor under gravity g the sum is 2 g h. If the two bodies
 pressed each other in the previous step, ā replaces a if it is greater.
 So a body that is thrown at an island is not affected by the load on the island. */
class ExternalLoads {
 public:
  /** Sets the load accelerations, the speculative margin and the slop of all bodies for a
   step of `h` [s]. `pairs` are the contact pairs of the previous step. */
  void Update(std::span<const ContactPair> pairs, std::span<const DistanceJoint> joints,
              std::span<const Spring> springs, const Settings& settings, double h,
              std::span<RigidBody> bodies);

  /** The greatest speculative margin of a body. [m] */
  double max_speculative_margin() const { return max_speculative_margin_; }

 private:
  /** The mass and load of an island. */
  struct Island {
    double mass = 0;    ///< [kg]
    double excess = 0;  ///< Σ m (a − |g|): exactly 0 under gravity alone. [N]
  };

  double max_speculative_margin_ = 0;
  UnionFind joined_;
  std::vector<Island> islands_;                   ///< Indexed by root of the island.
  std::vector<Eigen::Vector3d> spring_forces_W_;  ///< Indexed by body. [N]
};

}  // namespace cookbook
