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
  /** Maps a point x_W of the world to x_V = S x_W + offset in the variant. Orthogonal;
   its determinant is −1 for the mirror. */
  Eigen::Matrix3d S = Eigen::Matrix3d::Identity();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< [m]
  /** Body i of the variant is body `order[i]` of the world. */
  std::vector<int> order = {};
};

/** Returns the metamorphic variants of `world`: turned about gravity by an awkward angle,
 moved, mirrored, with its bodies in the opposite order, and with all masses, stiffnesses,
 forces and impulses times three. Mechanics says how each moves, so none needs a
 reference.

 A cloth is always aligned with the world's axes, so a world with a cloth is neither
 turned nor mirrored. A convex hull is in general not its own mirror image, so a world
 with one is not mirrored. A world with one body is not reordered. */
std::vector<WorldVariant> VariantsOf(const World& world);

/** Returns the claims of a world as they apply to its variant: S maps directions too. */
std::vector<Claim> ClaimsOf(const WorldVariant& variant, std::vector<Claim> claims);

/** Returns a point of a variant mapped back into the world itself. [m] */
Eigen::Vector3d SeenInWorld(const WorldVariant& variant, const Eigen::Vector3d& p_V);

/** Returns the motion of a variant mapped back into the world itself. */
Trajectory SeenInWorld(const WorldVariant& variant, Trajectory trajectory);

}  // namespace touchstone
