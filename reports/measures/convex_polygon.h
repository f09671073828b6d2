#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** Returns the convex hull of points in a plane, counterclockwise, without collinear
 points; one or two points if the input has no area. Source: Andrew's monotone chain,
 Information Processing Letters 9(5), 1979. */
std::vector<Eigen::Vector2d> ConvexHullOf(std::span<const Eigen::Vector2d> points);

/** Returns the distance of `p` from the convex polygon `hull`, 0 inside it.
 @pre `hull` was returned by ConvexHullOf() and is not empty. */
double DistanceFrom(std::span<const Eigen::Vector2d> hull, const Eigen::Vector2d& p);

/** Returns the vector to `p` from the nearest point of the convex polygon `hull`; zero
 inside it. @pre As for DistanceFrom(). */
Eigen::Vector2d OffsetFrom(std::span<const Eigen::Vector2d> hull,
                           const Eigen::Vector2d& p);

/** Returns the distance of `p`, inside or outside, from the boundary of `hull`. [m]
 @pre `hull` was returned by ConvexHullOf() and is not empty. */
double DistanceFromRim(std::span<const Eigen::Vector2d> hull, const Eigen::Vector2d& p);

/** Returns the points in coordinates along two axes orthogonal to the unit vector `n`. */
std::vector<Eigen::Vector2d> ProjectedAlong(const Eigen::Vector3d& n,
                                            std::span<const Eigen::Vector3d> points);

/** Returns the vector across the unit vector `n` whose coordinates along the two axes of
 ProjectedAlong() are `d`. */
Eigen::Vector3d LiftedAcross(const Eigen::Vector3d& n, const Eigen::Vector2d& d);

}  // namespace touchstone
