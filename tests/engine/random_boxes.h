#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "engine/collision/shape.h"

namespace cookbook::test {

/** A contact query: two boxes at their poses. */
struct BoxQuestion {
  Box A;
  Pose X_WA;
  Box B;
  Pose X_WB;
};

/** Random numbers that are the same on every machine: the standard fixes the generator,
 and its distributions are not used. Draw once per statement: the order of two draws in
 one expression is up to the compiler. */
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  double Between(double low, double high);
  double LogBetween(double low, double high);
  int Below(int count);
  Eigen::Vector3d InCube();              ///< A point with coordinates within ±1.
  Eigen::Vector3d Direction();           ///< A unit vector.
  Eigen::Vector3d Within(double reach);  ///< A vector up to `reach` long.
  Eigen::Matrix3d Rotation();

 private:
  std::mt19937_64 generator_;
};

/** Returns the rotation by `angle` about the unit `axis`. */
Eigen::Matrix3d Turn(const Eigen::Vector3d& axis, double angle);

/** A family of hard cases: its name, and the function that draws a case. */
struct Family {
  std::string name;
  BoxQuestion (*draw)(Random&);
};

/** Draws half extents of 0.1 to 2 m, any rotations, and centres of which 6 in 10 make the
 boxes overlap. */
BoxQuestion AnyBoxes(Random& random);

/** Returns all families that the engine is tested on. */
const std::vector<Family>& Families();

}  // namespace cookbook::test
