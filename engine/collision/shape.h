#pragma once

#include <Eigen/Core>

// With -mavx2 or -march=native Eigen would align its types otherwise than the installed
// library does. The CMake target sets the alignment.
static_assert(
    EIGEN_MAX_STATIC_ALIGN_BYTES == 16 && !Eigen::Matrix3d::IsRowMajor,
    "The engine stores Eigen's types column-major and aligned to 16 bytes: link the "
    "CMake target "
    "touchstone::engine, compile with -DEIGEN_MAX_ALIGN_BYTES=16, and define none of "
    "EIGEN_DONT_VECTORIZE, EIGEN_DONT_ALIGN, EIGEN_MAX_STATIC_ALIGN_BYTES and "
    "EIGEN_DEFAULT_TO_ROW_MAJOR.");

namespace cookbook {

/** The pose of a body in the world: x_W = R_WB x_B + p_WB. */
struct Pose {
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();  ///< A rotation, to rounding.
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();      ///< Origin of the body. [m]
};

/** A sphere centred on its body origin. */
struct Sphere {
  double radius;  ///< [m], > 0
};

/** A box centred on its body origin, with its edges along the body axes. */
struct Box {
  Eigen::Vector3d half_extents;  ///< [m], each > 0
};

}  // namespace cookbook
