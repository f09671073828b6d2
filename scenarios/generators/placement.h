#pragma once

#include "scenarios/contact_query.h"
#include "scenarios/generators/feature.h"
#include "scenarios/generators/random.h"

namespace touchstone {

/** Returns a pose with any rotation, its origin in the cube [-2, 2]³ m. */
Pose RandomPose(Random& random);

/** Returns `shape` placed such that its feature `on_B` faces the feature `on_A` of A
 across `gap`. The outward directions are opposite, with a random spin about them. */
Body PlacedAgainst(const Body& A, const Feature& on_A, const Shape& shape,
                   const Feature& on_B, double gap, Random& random);

/** Returns the distance between the origins of A and of `shape`, rotated by `X_WB`, along
 the unit vector `n_W` when a plane normal to it touches both. [m]
 @pre If A is a half-space, n_W is its normal; if `shape` is one, n_W is opposite to its
 normal. */
double DistanceAcrossPlane(const Body& A, const Shape& shape, const Pose& X_WB,
                           const Eigen::Vector3d& n_W);

/** Returns `shape` rotated by `X_WB` (its position is ignored) and placed such that its
 support point towards the feature `on_A` of A faces that feature across `gap`.
 @pre Neither is a half-space. */
Body PlacedOn(const Body& A, const Feature& on_A, const Shape& shape, const Pose& X_WB,
              double gap);

/** Returns `shape` rotated by `X_WB` (its position is ignored) and placed at `gap` from A
 along the unit vector `n_W`. It is shifted sideways by a random vector of length `shift`,
 minus the vector's component along n.
 @pre If A is a half-space, n_W is its normal; if B is one, n_W is opposite to its normal.
 */
Body PlacedAlong(const Body& A, const Shape& shape, const Pose& X_WB,
                 const Eigen::Vector3d& n_W, double gap, double shift, Random& random);

/** Returns the direction from A to B that a half-space determines: A's normal, or minus
 B's; `otherwise` if neither is a half-space. World frame. */
Eigen::Vector3d DirectionOr(const Eigen::Vector3d& otherwise, const Body& A,
                            const Shape& shape, const Pose& X_WB);

}  // namespace touchstone
