#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** How far a motion strays from its start, whatever its world claims: the largest values
 over its samples, of everything that moves. Fixed bodies and anchors may cause them. */
struct MotionDrifts {
  double energy_gained = 0;  ///< Rise of the energy above an earlier value. [J]
  double energy_lost = 0;    ///< Fall of the energy below the start. [J]
  /** Change of the momentum beyond gravity, forces and pushes. [N s] */
  double momentum = 0;
  /** Change of the angular momentum about the centre of mass. [N m s] */
  double angular_momentum = 0;
};

/** Returns the drifts of an answered motion. */
MotionDrifts DriftsOf(const World& world, const Trajectory& trajectory);

}  // namespace touchstone
