#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A running simulation of a world in an engine. Not thread safe. */
class Simulation {
 public:
  virtual ~Simulation() = default;

  /** Applies the impulse `J_W` [N s] to a body at the world point `p_W` [m], at once. */
  virtual void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W) = 0;

  /** Advances by one step of World::dt. */
  virtual void Step() = 0;

  /** Overwrites `state` with the current state of the world. */
  virtual void Read(WorldState& state) const = 0;

  /** Appends the impulse of each contact of the last step. The caller sets their `step`.
   */
  virtual void ReadImpulses(std::vector<ContactImpulse>& impulses) const;

  /** Whether ReadImpulses() returns the impulses that the engine applied. */
  virtual bool GivesImpulses() const { return false; }
};

/** Returns whether every number is finite, and every position and speed is below
 kMostReached (scenarios/worlds/magnitudes.h): the motion has not diverged. */
bool IsSane(const WorldState& state);

/** Returns the same of an impulse: it is one that a valid world can have. */
bool IsSane(const ContactImpulse& contact);

/** Runs `simulation` of `world` from start to end. Applies the pushes at their times,
 takes a sample every World::sample_every steps, and stops when a state diverges. */
Trajectory RunToEnd(Simulation& simulation, const World& world);

}  // namespace touchstone
