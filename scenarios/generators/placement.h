#pragma once

#include "scenarios/contact_query.h"
#include "scenarios/generators/feature.h"
#include "scenarios/generators/random.h"

namespace touchstone {

/** Returns a pose with any rotation, its origin in the cube [-2, 2]³ m. */
Pose RandomPose(Random& random);

/** Returns `shape` placed so that its feature `on_B` meets the feature `on_A` of A across
 `gap`, outward directions opposed, with any spin about them. */
Body PlacedAgainst(const Body& A, const Feature& on_A, const Shape& shape,
                   const Feature& on_B, double gap, Random& random);

/** Returns how far the origins of A and of `shape`, turned by `X_WB`, are apart along the
 unit vector `n_W` where a plane across it touches both. [m]
 @pre Where A is a half-space n_W is its normal; where `shape` is, the opposite of its
 normal. */
double DistanceAcrossPlane(const Body& A, const Shape& shape, const Pose& X_WB,
                           const Eigen::Vector3d& n_W);

/** Returns `shape` turned by `X_WB` (whose place is ignored) and placed so that its
 support point against the feature `on_A` of A meets it across `gap`. @pre Neither is a
 half-space. */
Body PlacedOn(const Body& A, const Feature& on_A, const Shape& shape, const Pose& X_WB,
              double gap);

/** Returns `shape` turned by `X_WB` (whose place is ignored) and placed at `gap` from A
 along the unit vector `n_W`, shifted sideways by a random vector of length `shift` less
 its part along n.
 @pre Where A is a half-space n_W is its normal; where B is, the opposite of its normal.
 */
Body PlacedAlong(const Body& A, const Shape& shape, const Pose& X_WB,
                 const Eigen::Vector3d& n_W, double gap, double shift, Random& random);

/** Returns the direction from A to B that a half-space dictates: A's normal, or minus
 B's; and `otherwise` where neither is one. World frame. */
Eigen::Vector3d DirectionOr(const Eigen::Vector3d& otherwise, const Body& A,
                            const Shape& shape, const Pose& X_WB);

}  // namespace touchstone
