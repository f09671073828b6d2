#pragma once

#include <string>

#include <Eigen/Core>

namespace touchstone {

/** Returns a vector as text, e.g. "(0.125, -0.6, 0.7905694150420949)", with the fewest
 digits that read back as `v`. -0 is written as 0. */
std::string FormatVector(const Eigen::Vector3d& v);

/** The same with `digits` significant digits: "(1, -0.5, 3.25)". */
std::string FormatVector(const Eigen::Vector3d& v, int digits);

}  // namespace touchstone
