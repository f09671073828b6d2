#pragma once

#include <Eigen/Core>

#include "reports/referee/precise.h"
#include "reports/referee/vector.h"

namespace touchstone::referee {

/** Returns the vector of doubles nearest to `a`. */
inline Eigen::Vector3d Rounded(const Vector<Precise>& a) {
  return {Nearest(a.x), Nearest(a.y), Nearest(a.z)};
}

/** Returns the unit vector along `a`, each coordinate rounded once, or zero for zero. */
inline Eigen::Vector3d Direction(const Vector<Precise>& a) {
  const Precise length = sqrt(Dot(a, a));
  if (!(length > 0)) return Eigen::Vector3d::Zero();
  return Rounded((Precise(1) / length) * a);
}

}  // namespace touchstone::referee
