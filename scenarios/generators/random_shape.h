#pragma once

#include "scenarios/generators/random.h"
#include "scenarios/shape.h"

namespace touchstone {

/** Returns a shape of `kind` with every size in [0.2, 1.2] m. A hull has 8 to 12
 vertices, all of them corners, and contains the ball of radius 0.04 m about its origin.
 */
Shape RandomShape(ShapeKind kind, Random& random);

/** Returns a shape as RandomShape() does, except that a hull has 16 to 1,000 vertices. */
Shape RandomLargeShape(ShapeKind kind, Random& random);

/** Returns a slab, a disc or a needle of `kind`: some sizes are in [0.2, 1.2] m, the
 others thinner by a factor of 10^1 to 10^4. A sphere has a small radius; a half-space has
 no size. */
Shape RandomThinShape(ShapeKind kind, Random& random);

/** Returns the smallest size of `shape`: the least of its radii, half extents, half
 lengths and half heights; for a hull its InnerRadius(); for a half-space 1. [m] */
double Thickness(const Shape& shape);

/** Returns the radius of the largest ball about the origin inside `shape`; for a
 half-space 0, since its origin is on its boundary. [m]
 @pre A hull contains its origin and has at most a few dozen vertices. */
double InnerRadius(const Shape& shape);

/** Returns a support point of `shape`: one where n · x is largest, body frame; for a
 half-space its origin. [m]
 @pre n_B is a unit vector, and +z for a half-space. */
Eigen::Vector3d SupportPoint(const Shape& shape, const Eigen::Vector3d& n_B);

}  // namespace touchstone
