#include "scenarios/cube_rotations.h"

namespace touchstone {

Eigen::Matrix3d CubeRotation(int index) {
  // Six permutations of the axes: the three cyclic ones, then the three that also swap
  // two axes.
  const int permutation = index / 4;
  const int signs = index % 4;
  const bool swapped = permutation >= 3;
  // Two columns take any signs; the sign of the third makes the determinant +1.
  const double x = signs & 1 ? -1 : 1;
  const double y = signs & 2 ? -1 : 1;
  const double z = x * y * (swapped ? -1 : 1);
  Eigen::Matrix3d R = Eigen::Matrix3d::Zero();
  R(permutation % 3, 0) = x;
  R((permutation + (swapped ? 2 : 1)) % 3, 1) = y;
  R((permutation + (swapped ? 1 : 2)) % 3, 2) = z;
  return R;
}

}  // namespace touchstone
