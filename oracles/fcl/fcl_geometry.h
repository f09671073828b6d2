#pragma once

#include <memory>

#include <Eigen/Geometry>

#include "scenarios/contact_query.h"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace touchstone {

/** A body as FCL takes it. */
struct FclBody {
  /** Null for a convex hull without volume, for which FCL's Convex has no faces. */
  std::shared_ptr<const fcl::CollisionGeometry<double>> geometry;
  Eigen::Isometry3d X_WB;
};

/** Two bodies as FCL takes them. */
struct FclPair {
  FclBody A;
  FclBody B;

  /** Whether FCL can be asked: both have a geometry. */
  explicit operator bool() const { return A.geometry && B.geometry; }
};

/** Translates both bodies: full sizes, the same axes, a hull with its faces. */
FclPair ToFcl(const ContactQuery& query);

}  // namespace touchstone
