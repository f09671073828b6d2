#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A changed world whose motion follows from that of the world itself. */
struct WorldVariant {
  MeasureKind measure;  ///< kHeading … kMassScaling.
  World world;
  /** x_V = S x_W + offset: where what was at x_W is in the variant. Orthogonal; of
   determinant −1 for the mirror. */
  Eigen::Matrix3d S = Eigen::Matrix3d::Identity();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< [m]
  /** Body i of the variant is body `order[i]` of the world. */
  std::vector<int> order = {};
};

/** Returns the metamorphic variants of `world`: turned about gravity by an awkward angle,
 moved, mirrored, its bodies in the opposite order, all masses (with stiffnesses, forces
 and blows) times three. A law of mechanics each: none needs a reference.

 A cloth knows only the world's axes, so that a world with one is neither turned nor
 mirrored, and one with a hull, which is not its own mirror image, not mirrored; a world
 of one body is not reordered. */
std::vector<WorldVariant> VariantsOf(const World& world);

/** Returns the claims of a world as they hold of its variant: directions turn with it. */
std::vector<Claim> ClaimsOf(const WorldVariant& variant, std::vector<Claim> claims);

/** Returns the motion of a variant as seen in the world itself. */
Trajectory SeenInWorld(const WorldVariant& variant, Trajectory trajectory);

}  // namespace touchstone
