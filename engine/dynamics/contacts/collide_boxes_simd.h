#pragma once

#include <cstddef>
#include <span>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/rigid_body.h"

namespace cookbook {

/** Two bodies that may touch, and what is to be known of how they do. */
struct Neighbours {
  const RigidBody* A;
  const RigidBody* B;
  double margin;              ///< Contacts apart by no more count. [m]
  Eigen::Vector3d n_guess_W;  ///< As of CollideSpeculative().
  Manifold* manifold;         ///< Where it is written.
};

/** Pairs of boxes that are looked at together. */
inline constexpr std::size_t kNeighbours = 8;

/** Fills the manifolds of at most kNeighbours pairs of boxes as CollideSpeculative()
 says, each contact midway. Returns a bit for each pair of which two edges meet, apart
 from all faces: its manifold then has its normal and separation, and no contacts. */
unsigned CollideBoxesSimd(std::span<const Neighbours> boxes);

}  // namespace cookbook
