#pragma once

#include <ostream>
#include <string_view>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Writes the header of the table: world,oracle,time,name,px,py,pz,qw,qx,qy,qz,vx,vy,vz,
 wx,wy,wz. SI units, world frame. */
void WriteTrajectoryHeader(std::ostream& out);

/** Writes a row for each sample and each thing that moves: bodies, particles, and nodes
 of a cloth as NAME[row][column]. Points have no orientation and no spin: empty cells.
 Numbers are the shortest that read back as the same double. */
void WriteTrajectory(const WorldScenario& scenario, std::string_view oracle,
                     const Trajectory& trajectory, std::ostream& out);

}  // namespace touchstone
