#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** How two bodies penetrate each other. */
struct DeepestOverlap {
  /** A certified lower bound of the penetration depth; 0 if they are apart, or if neither
   is certain. [m] */
  double depth = 0;
  /** The direction of that depth, unit, from A to B. World frame. */
  Eigen::Vector3d n_W = Eigen::Vector3d::Zero();
  /** A deepest point, on the surface of the body with the smaller bounding sphere: the
   other body's may be a corner far away. World frame. [m] */
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
};

/** Returns how bodies A and B penetrate each other. Direction and point are zero if the
 depth is.

 @pre Not both are half-spaces. */
DeepestOverlap OverlapOf(const World& world, const WorldState& state, int A, int B);

/** Returns a certified lower bound of how deep a point is in body `index`; 0 outside.
 [m] */
double DepthOfPoint(const World& world, const WorldState& state, int index,
                    const Eigen::Vector3d& p_W);

/** The nearest points of two bodies. */
struct Gap {
  double length = 0;  ///< A certified upper bound; 0 if they touch or penetrate. [m]
  /** Its direction, unit, from A to B. World frame. */
  Eigen::Vector3d n_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_WA = Eigen::Vector3d::Zero();  ///< On A. [m]
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< On B. [m]
};

/** Returns the gap between bodies A and B. @pre Not both are half-spaces. */
Gap GapBetween(const World& world, const WorldState& state, int A, int B);

/** Returns whether the bounding spheres of two bodies are farther apart than `margin`
 [m]. */
bool AreFarApart(const Body& A, const Body& B, double margin);

/** Returns the shape of body `index` at its pose in `state`. */
Body PlacedAt(const World& world, const WorldState& state, int index);

}  // namespace touchstone
