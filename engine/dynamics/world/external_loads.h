#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/joints/distance_joint.h"
#include "engine/dynamics/joints/spring.h"
#include "engine/dynamics/solver/union_find.h"

namespace cookbook {

/** How hard the bodies of a world are pulled, which is the measure of what counts for
 rest: contacts that are kept ready, depths that are left, approaches that do not bounce.

 What loads a body makes of it, if nothing holds it,

   a = max(|g + F/m| + |τ|/(m r), |S|/m),

 with F and τ the forces and torques on it, S the sum of its springs and r its radius. So
 gravity and a constant force that make the same motion make the same measure, and what
 falls with the frame in which it is seen weighs nothing; what hangs on a spring does. A
 torque loads as a force at the arm r would. Points touch nothing that is solved, and
 their springs are left out.

 Contacts, rods and springs pass on what presses them. A island is what they joined in the
 step before, without what is static, and pulled as hard as

   ā = Σ m a / Σ m,

 the gravity under which it would weigh as much as now loads at it. A mean by mass, so
 that a light body under a great force does to a island what it can; and of a island,
 since others are none of its business.

 Contacts are kept ready, and depths left, up to 2 ā h²; but where forces load harder than
 gravity, no further than a fiftieth of the inner radius of the body, or 2 |g| h² where
 that is more: what forces press may be small, and pressed as in a vice. Two bodies take
 the less of both, the margin that either of them bears.

 An approach does not bounce that is slower than what the greater of their a makes of a
 step; or ā, where the two press each other already: what is thrown at a island gets
 nothing of what presses that. */
class ExternalLoads {
 public:
  /** Finds of each moving body how hard it is pulled in a step of `h` [s], and what
   follows from that, given the contacts of the step before. */
  void Find(std::span<const ContactPair> contacts, std::span<const DistanceJoint> joints,
            std::span<const Spring> springs, const Settings& settings, double h,
            std::span<RigidBody> bodies);

  /** The greatest margin of a body. [m] */
  double greatest_margin() const { return greatest_margin_; }

 private:
  /** What a island is made of. */
  struct Island {
    double mass = 0;    ///< [kg]
    double excess = 0;  ///< Σ m (a − |g|): of gravity alone 0, without rounding. [N]
  };

  double greatest_margin_ = 0;
  UnionFind joined_;
  std::vector<Island> islands_;                   ///< By body that stands for it.
  std::vector<Eigen::Vector3d> spring_forces_W_;  ///< By body. [N]
};

}  // namespace cookbook
