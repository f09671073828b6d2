#pragma once

#include <memory>
#include <vector>

#include "engine/dynamics/body/body.h"
#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/joints/distance_joint.h"
#include "engine/dynamics/joints/spring.h"
#include "engine/dynamics/world/contact_impulse.h"

namespace cookbook {

/** A world of rigid bodies, points, joints and springs that is stepped in time. See
 docs/dynamics.md for the stages of a step. Bodies are identified by the index that
 AddBody() returned: 0, 1, 2, …

 The same calls give the same bits, for any number of threads. Member functions with
 invalid arguments throw std::invalid_argument with a sentence and leave the world
 unchanged. */
class World {
 public:
  /** @throws std::invalid_argument with a sentence that names the invalid setting. */
  explicit World(const Settings& settings = {});
  ~World();

  int AddBody(const BodyDefinition& definition);

  /** Adds a distance joint; returns its index among the joints.
   @throws std::invalid_argument if an anchor names no body, both anchors are on the same
   body, a number is not finite, or the length is not positive. */
  int AddJoint(const DistanceJoint& joint);

  /** Adds a spring; returns its index among the springs.
   @throws std::invalid_argument like AddJoint(), and if a constant is negative. */
  int AddSpring(const Spring& spring);

  /** Applies an impulse [N s] at a world point [m] immediately. Has no effect on static
   bodies. */
  void ApplyImpulse(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W);

  /** Applies a force [N] at a world point [m] for the whole of the next step. Its torque
   is that of the current position of the body. */
  void ApplyForce(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& F_W);

  /** Advances by `dt` [s], > 0. Has no effect on a world that has diverged. */
  void Step(double dt);

  int body_count() const;
  /** Returns the state of a body. The reference is valid until AddBody(). */
  const BodyState& state(int body) const;
  const Settings& settings() const;

  /** Whether a body sleeps, see Settings::sleep_after. */
  bool IsAsleep(int body) const;

  /** Appends the impulses of all touching contacts in the last sub-step. */
  void AppendContactImpulses(std::vector<ContactImpulse>& impulses) const;

  /** Whether a state is no longer finite, or has exceeded 1e12 in SI units. */
  bool diverged() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cookbook
