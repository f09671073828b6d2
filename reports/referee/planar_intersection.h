#pragma once

#include <vector>

#include <Eigen/Core>

namespace touchstone::referee {

/** A convex polygon, counterclockwise; a segment if it has two points, a point if it has
 one. */
using Polygon = std::vector<Eigen::Vector2d>;

/** Returns the corners of the convex hull of the points. A corner less than `slack` off
 the line of its neighbours, or off a neighbour, is dropped: a sliver becomes a segment or
 a point. [m] */
Polygon HullOf(std::vector<Eigen::Vector2d> points, double slack);

/** Returns the intersection of two polygons made by HullOf(). Sides are moved outwards by
 `slack`. Segments that diverge by less than `parallel` count as parallel. If the polygons
 are disjoint, the result is the point midway between them. [m] */
Polygon Intersect(const Polygon& P, const Polygon& Q, double slack, double parallel);

}  // namespace touchstone::referee
