#pragma once

#include "scenarios/generators/random.h"
#include "scenarios/shape.h"

namespace touchstone {

/** What of a surface meets: the dimension of the set that a plane of support touches. A
 curved surface has what comes nearest: a sphere is all faces, the rim of a disc is an
 edge, and where there is no such feature at all (a capsule's edge), there is a face or a
 cap instead. */
enum class FeatureKind { kVertex, kEdge, kFace };

/** A place on a surface with a direction that leads straight out of it. */
struct Feature {
  Eigen::Vector3d p_B;  ///< On the surface, body frame. [m]
  /** Unit outward direction: the shape lies in {x : n · (x − p) <= 0}, up to rounding.
   Strictly inside the normal cone of a vertex or edge. */
  Eigen::Vector3d n_B;
};

/** Returns a random feature of that kind, away from the borders of an edge or face. */
Feature RandomFeature(const Shape& shape, FeatureKind kind, Random& random);

}  // namespace touchstone
