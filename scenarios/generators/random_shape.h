#pragma once

#include "scenarios/generators/random.h"
#include "scenarios/shape.h"

namespace touchstone {

/** Returns a shape of that kind with every size in [0.2, 1.2] m. A hull has 8 to 12
 vertices, all of them corners, and holds the ball of radius 0.04 m about its origin. */
Shape RandomShape(ShapeKind kind, Random& random);

/** Returns a shape of that kind, long in some of its dimensions (in [0.2, 1.2] m) and
 thinner by 10^1 to 10^4 in the others: a slab, a disc, a needle. Of a sphere the radius
 is thin, of a half-space nothing. */
Shape RandomThinShape(ShapeKind kind, Random& random);

/** Returns the least size of `shape`: the smallest of its radii, half lengths and half
 heights; for a hull its InnerRadius(); for a half-space 1. [m] */
double Thickness(const Shape& shape);

/** Returns the radius of the largest ball about the origin inside `shape`; for a
 half-space 0, its origin being on its boundary. [m]
 @pre A hull holds its origin and has at most a few dozen vertices. */
double InnerRadius(const Shape& shape);

/** Returns a point of `shape` where n · x is largest, body frame; for a half-space its
 origin. [m]
 @pre n_B is a unit vector, and +z for a half-space. */
Eigen::Vector3d SupportPoint(const Shape& shape, const Eigen::Vector3d& n_B);

}  // namespace touchstone
