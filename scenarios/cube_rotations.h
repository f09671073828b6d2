#pragma once

#include <Eigen/Core>

namespace touchstone {

inline constexpr int kCubeRotations = 24;

/** Returns the `index`-th of the 24 rotations that map a cube to itself: signed
 permutation matrices of determinant +1, exact in any arithmetic. Index 0 is the identity.
 @pre 0 <= index < kCubeRotations. */
Eigen::Matrix3d CubeRotation(int index);

}  // namespace touchstone
