#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "scenarios/shape.h"

namespace touchstone {

/** Returns `x` as an expression of type btScalar. */
std::string BulletScalar(double x);

/** Returns `v` as an expression of type btVector3. */
std::string BulletVector(const Eigen::Vector3d& v);

/** Returns the definition of a local variable `name` with the shape. */
std::string DefineBulletShape(std::string_view name, const Shape& shape);

/** Returns the pkg-config module of the build that an oracle uses. */
std::string_view BulletBuild(std::string_view oracle);

/** Returns the CMake lines that define the target `engine` as that build. */
std::string FindBullet(std::string_view oracle);

}  // namespace touchstone
