#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A world that an engine has begun to simulate. Not thread safe. */
class Simulation {
 public:
  virtual ~Simulation() = default;

  /** Applies the impulse `J_W` [N s] at the world point `p_W` [m] of a body now. */
  virtual void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W) = 0;

  /** Advances by one step of World::dt. */
  virtual void Step() = 0;

  /** Overwrites `state` with the world as it is now. */
  virtual void Read(WorldState& state) const = 0;

  /** Appends what each contact did in the last step, with `step` left for the caller. */
  virtual void ReadImpulses(std::vector<ContactImpulse>& impulses) const;

  /** Whether ReadImpulses() gives what the engine applied. */
  virtual bool GivesImpulses() const { return false; }
};

/** Runs `simulation` of `world` from its start to its end: pushes at their times, a
 sample every World::sample_every steps, and an end where a state diverges. */
Trajectory RunToEnd(Simulation& simulation, const World& world);

}  // namespace touchstone
