#pragma once

#include <vector>

#include <Eigen/Core>

namespace touchstone::referee {

/** A convex polygon, counterclockwise; a segment where it has two points, a point where
 * one. */
using Polygon = std::vector<Eigen::Vector2d>;

/** Returns the corners of the convex hull. Corners less than `slack` off the line of
 their neighbours, or off a neighbour, are dropped: a sliver becomes a segment or a point.
 [m] */
Polygon HullOf(std::vector<Eigen::Vector2d> points, double slack);

/** Returns the intersection of two polygons made by HullOf(). Sides grow by `slack`;
 segments that stray from each other by less than `parallel` count as parallel. Where they
 do not meet at all, the point midway between them. [m] */
Polygon Intersect(const Polygon& P, const Polygon& Q, double slack, double parallel);

}  // namespace touchstone::referee
