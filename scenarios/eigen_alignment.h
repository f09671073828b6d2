#pragma once

#include <Eigen/Core>

// Eigen aligns fixed-size vectors by the widest instructions it is compiled for, so that
// -mavx2 or -march=native would give Pose and all that holds one another layout than in
// the installed libraries. The CMake targets touchstone::* set the alignment; this
// refuses a program that is built without them.
static_assert(
    EIGEN_MAX_STATIC_ALIGN_BYTES == 16 && !Eigen::Matrix3d::IsRowMajor,
    "Touchstone stores Eigen's types column-major and aligned to 16 bytes: link the "
    "CMake target "
    "touchstone::touchstone, compile with -DEIGEN_MAX_ALIGN_BYTES=16, and define none of "
    "EIGEN_DONT_VECTORIZE, EIGEN_DONT_ALIGN, EIGEN_MAX_STATIC_ALIGN_BYTES and "
    "EIGEN_DEFAULT_TO_ROW_MAJOR.");
