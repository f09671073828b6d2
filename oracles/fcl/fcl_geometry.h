#pragma once

#include <memory>

#include <Eigen/Geometry>

#include "scenarios/contact_query.h"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace touchstone {

/** A body in FCL's types. */
struct FclBody {
  /** Null for a convex hull without volume: it has no faces for FCL's Convex. */
  std::shared_ptr<const fcl::CollisionGeometry<double>> geometry;
  Eigen::Isometry3d X_WB;
};

/** Two bodies in FCL's types. */
struct FclPair {
  FclBody A;
  FclBody B;

  /** Whether FCL can be called: both bodies have a geometry. */
  explicit operator bool() const { return A.geometry && B.geometry; }
};

/** Returns both bodies in FCL's types: full sizes, the same axes, hulls with faces. */
FclPair ToFcl(const ContactQuery& query);

}  // namespace touchstone
