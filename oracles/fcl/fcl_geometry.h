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

/** Translates `body`: full sizes, the same axes, a hull with its faces. */
FclBody ToFcl(const Body& body);

}  // namespace touchstone
