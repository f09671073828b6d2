#pragma once

#include <filesystem>
#include <vector>

#include "scenarios/diagnostic.h"
#include "scenarios/worlds/motion_expectation.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** The states of a trajectory file, or its errors. */
struct ReadTrajectory {
  std::vector<ReferenceState> states;
  std::vector<Diagnostic> errors;  ///< In the trajectory file; the first ones.
};

/** Reads the states of bodies and particles of `world` from a CSV file. Its first line
 names the columns, in any order: time [s], name, px, py, pz [m], and for bodies, if they
 are to be compared, qw, qx, qy, qz. Other columns are left out. Errors are a name that
 the world does not have, a time that is not that of a sample, and rows of two oracles.
 @pre The clock of `world` has no faults. */
ReadTrajectory ReadTrajectoryFile(const std::filesystem::path& file, const World& world);

}  // namespace touchstone
