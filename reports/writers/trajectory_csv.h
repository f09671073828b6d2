#pragma once

#include <ostream>
#include <string_view>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Writes the header of the table: world,oracle,time,name,px,py,pz,qw,qx,qy,qz,vx,vy,vz,
 wx,wy,wz. The columns are in SI units and the world frame. */
void WriteTrajectoryHeader(std::ostream& out);

/** Writes a row for each sample and each moving object: bodies, particles, and nodes of a
 cloth as NAME[row][column]. The cells of orientation and angular velocity are empty for
 points. Numbers have the fewest digits that read back as the same double. */
void WriteTrajectory(const WorldScenario& scenario, std::string_view oracle,
                     const Trajectory& trajectory, std::ostream& out);

}  // namespace touchstone
