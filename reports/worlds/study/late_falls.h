#pragma once

#include <vector>

#include <Eigen/Core>

#include "oracles/trajectory.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** Returns, for each body, the fall that a contact which misses a step may add. World
 frame. [m]

 Bodies that touch at the start to within its rounding may or may not be in contact in a
 step: the last bit decides. A body without its contact falls a h² in that step, along its
 load a, and then has a contact that no rounding decides. So each such contact of a
 cluster adds one such fall to all its bodies, whenever it comes. It explains no motion
 across the load, and none of a body that touches nothing at the start: zero. */
std::vector<Eigen::Vector3d> LateFallsOf(const Study& study);

/** Returns `motion` with each body moved along its fall towards where it is in
 `reference`, by the length of the fall at most. */
Trajectory WithoutLateFalls(Trajectory motion, const Trajectory& reference,
                            const std::vector<Eigen::Vector3d>& falls);

}  // namespace touchstone
