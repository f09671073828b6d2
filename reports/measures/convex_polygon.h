#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** Returns the convex hull of points of a plane, counter-clockwise, without collinear
 points; one or two points where the input has no area. Source: Andrew's monotone chain,
 Information Processing Letters 9(5), 1979. */
std::vector<Eigen::Vector2d> ConvexHullOf(std::span<const Eigen::Vector2d> points);

/** Returns the distance of `p` from the convex polygon `hull`, 0 inside it.
 @pre `hull` is what ConvexHullOf() returns, not empty. */
double DistanceFrom(std::span<const Eigen::Vector2d> hull, const Eigen::Vector2d& p);

/** Returns the points as coordinates in two axes orthogonal to the unit vector `n`. */
std::vector<Eigen::Vector2d> ProjectedAlong(const Eigen::Vector3d& n,
                                            std::span<const Eigen::Vector3d> points);

}  // namespace touchstone
