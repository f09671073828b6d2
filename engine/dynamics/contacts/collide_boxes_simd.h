#pragma once

#include <cstddef>
#include <span>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/rigid_body.h"

namespace cookbook {

/** Input and output of the collision of two bodies. */
struct CollisionPair {
  const RigidBody* A;
  const RigidBody* B;
  double margin;              ///< Speculative margin. [m]
  Eigen::Vector3d n_guess_W;  ///< See CollideSpeculative().
  Manifold* manifold;         ///< The result.
};

/** Number of pairs of boxes that are collided together. */
inline constexpr std::size_t kPairsPerBatch = 8;

/** Fills the manifolds of at most kPairsPerBatch pairs of boxes like
 CollideSpeculative(), with contact points midway between the surfaces. Returns a mask of
 the pairs whose contact is between two edges. The manifold of such a pair has its normal
 and separation, but no contact points. */
unsigned CollideBoxesSimd(std::span<const CollisionPair> batch);

}  // namespace cookbook
