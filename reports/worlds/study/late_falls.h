#pragma once

#include <vector>

#include <Eigen/Core>

#include "oracles/trajectory.h"
#include "reports/worlds/study/study.h"

namespace touchstone {

/** The falls that contacts which miss a step may add to a body. */
struct LateFall {
  Eigen::Vector3d each_W = Eigen::Vector3d::Zero();  ///< One fall, a h². [m]
  double most = 0;                                   ///< The number of contacts.
};

/** Returns the late falls of each body.

 Bodies that touch at the start to within its rounding may or may not be in contact in a
 step: the last bit decides. A body without its contact falls a h² in that step, along its
 load a, and then has a contact that no rounding decides. So each such contact of a
 cluster adds one such fall to all its bodies, whenever it comes. It explains no other
 distance, no motion across the load, and none of a body that touches nothing at the
 start. */
std::vector<LateFall> LateFallsOf(const Study& study);

/** Returns `motion` with each body moved along its fall by the number of half falls, at
 most those of `falls`, that brings it nearest to where it is in `reference`. Schemes that
 move by the mean velocity of a step fall half as far. */
Trajectory WithoutLateFalls(Trajectory motion, const Trajectory& reference,
                            const std::vector<LateFall>& falls);

}  // namespace touchstone
