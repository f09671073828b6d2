#pragma once

#include <optional>
#include <variant>

#include <Eigen/Geometry>

#include "engine/collision/shape.h"

namespace cookbook {

/** The solid {x : z <= 0} in the body frame, for static bodies. */
struct HalfSpace {};

/** A point mass without volume. It does not rotate. It collides only with static boxes
 and half-spaces, by continuous collision detection. */
struct Point {};

using BodyShape = std::variant<Sphere, Box, HalfSpace, Point>;

/** Pose and velocity of a body. World frame. */
struct BodyState {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< Centre of mass. [m]
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_WB =
      Eigen::Vector3d::Zero();  ///< Velocity of the centre of mass. [m/s]
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/** The initial state and the properties of a body that is added to a world. */
struct BodyDefinition {
  BodyShape shape = Sphere{0.5};
  BodyState state;
  double mass = 1;  ///< [kg]; 0: static, never moves, whatever its velocity.
  /** Principal moments along the body axes. Absent: those of a solid of uniform density.
   [kg m²] */
  std::optional<Eigen::Vector3d> inertia;
  double restitution = 0.5;  ///< In [0, 1]; a pair has the lesser of the two.
  double friction = 0.6;     ///< >= 0; a pair has the geometric mean.
  /** A constant force on the centre of mass, in addition to gravity. [N] */
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
  bool collides = true;  ///< False: the body passes through everything.
  /** Drag of a point: its velocity decays as exp(−drag t). [1/s], >= 0 */
  double drag = 0;
};

/** Returns the principal moments of inertia of `shape`. Sphere: 2/5 m r². Box with full
 sizes X, Y, Z: m/12 (Y²+Z², X²+Z², X²+Y²). [kg m²]
 @pre `shape` is a sphere or a box. */
Eigen::Vector3d PrincipalInertia(const BodyShape& shape, double mass);

/** Checks that a body is possible. Numbers must be finite, sizes positive, half-spaces
 static. Each moment of inertia is at most the sum of the other two, as in any solid.
 @throws std::invalid_argument with a sentence. */
void Validate(const BodyDefinition& body);

}  // namespace cookbook
