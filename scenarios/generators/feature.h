#pragma once

#include "scenarios/generators/random.h"
#include "scenarios/shape.h"

namespace touchstone {

/** The kind of a surface feature: the dimension of the set that a supporting plane
 touches. A curved surface has the nearest equivalent: a sphere has only faces, and the
 rim of a disc is an edge. A shape without such a feature (e.g. an edge of a capsule) has
 a face or a cap instead. */
enum class FeatureKind { kVertex, kEdge, kFace };

/** A point on a surface with an outward direction. */
struct Feature {
  Eigen::Vector3d p_B;  ///< Point on the surface, body frame. [m]
  /** Unit outward direction: the shape lies in {x : n · (x − p) <= 0}, up to rounding. It
   is strictly inside the normal cone of a vertex or edge. */
  Eigen::Vector3d n_B;
};

/** Returns a random feature of `kind`, away from the borders of an edge or face. */
Feature RandomFeature(const Shape& shape, FeatureKind kind, Random& random);

}  // namespace touchstone
