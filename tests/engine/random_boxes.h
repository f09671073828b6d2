#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "engine/collision/shape.h"

namespace cookbook::test {

/** Two boxes in place. */
struct BoxQuestion {
  Box A;
  Pose X_WA;
  Box B;
  Pose X_WB;
};

/** Numbers that are the same on every machine: the standard fixes the generator, and its
 distributions are not used. One draw a statement: of two in one expression the order is
 the compiler's. */
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  double Between(double low, double high);
  double LogBetween(double low, double high);
  int Below(int count);
  Eigen::Vector3d InCube();              ///< Coordinates within ±1.
  Eigen::Vector3d Direction();           ///< A unit vector.
  Eigen::Vector3d Within(double reach);  ///< As far as `reach` in any direction.
  Eigen::Matrix3d Rotation();

 private:
  std::mt19937_64 generator_;
};

/** Returns the rotation by `angle` about the unit `axis`. */
Eigen::Matrix3d Turn(const Eigen::Vector3d& axis, double angle);

/** A family of hard cases: what is varied, and how. */
struct Family {
  std::string name;
  BoxQuestion (*draw)(Random&);
};

/** Half extents 0.1 to 2 m, any rotation, centres so that 6 in 10 overlap. */
BoxQuestion AnyBoxes(Random& random);

/** Every family that the engine is measured on. */
const std::vector<Family>& Families();

}  // namespace cookbook::test
