#pragma once

#include <cmath>

#include <Eigen/Core>

#include "reports/referee/precise.h"
#include "reports/referee/vector.h"

namespace touchstone::referee {

/** Returns the vector of doubles nearest to `a`. */
template <typename Real>
Eigen::Vector3d Rounded(const Vector<Real>& a) {
  return {Nearest(a.x), Nearest(a.y), Nearest(a.z)};
}

/** Returns the unit vector along `a`, each coordinate rounded once, or to zero where it
 is a rounding of `Real`; zero for zero. */
template <typename Real>
Eigen::Vector3d Direction(const Vector<Real>& a) {
  const Real length = sqrt(Dot(a, a));
  if (!(length > 0)) return Eigen::Vector3d::Zero();
  Eigen::Vector3d n = Rounded((Real(1) / length) * a);
  // The search leaves roundings of `Real` where a component is zero.
  constexpr double kNothing = 64 * kRoundoff<Real>;
  for (double& x : n) x = std::abs(x) < kNothing ? 0 : x;
  return n;
}

}  // namespace touchstone::referee
