#pragma once

#include <string>

#include <Eigen/Core>
#include <fmt/format.h>

namespace touchstone {

/** Returns a vector as proofs print it: "(1, -0.5, 3.25)", nine digits each. */
inline std::string Words(const Eigen::Vector3d& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x(), v.y(), v.z());
}

}  // namespace touchstone
