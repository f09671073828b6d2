#pragma once

#include <string>

#include <Eigen/Core>

namespace touchstone {

/** Two numbers or vectors as text that shows how they differ. */
struct ToldApart {
  std::string a;
  std::string b;
  std::string difference;  ///< |a − b|, to three digits.
};

/** Writes `a` and `b` with `digits` significant digits, or with as many more as show two
 digits of their difference: numbers that differ never look equal. */
ToldApart TellApart(double a, double b, int digits);

/** The same for two vectors: their largest components show the difference. */
ToldApart TellApart(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int digits);

}  // namespace touchstone
