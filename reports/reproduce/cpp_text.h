#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "scenarios/pose.h"

namespace touchstone {

/** Returns `x` as a C++ literal of type double, with the fewest digits that read back as
 `x`. @pre x is finite. */
std::string Literal(double x);

/** Returns three literals, separated by commas. */
std::string Literals(const Eigen::Vector3d& v);

/** Returns the nine entries of `R` row by row, separated by commas. */
std::string Literals(const Eigen::Matrix3d& R);

/** Returns lines that turn u, v and w, the coordinates of a point in the world frame,
 into x, y and z, those in the frame of the body at `X_WB`. */
std::string InBodyFrame(const Pose& X_WB);

/** Returns `text` as a C++ string literal. Line ends become spaces; '%' is kept. */
std::string Quoted(std::string_view text);

}  // namespace touchstone
