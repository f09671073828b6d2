#pragma once

#include <optional>
#include <variant>

#include <Eigen/Geometry>

#include "engine/collision/shape.h"

namespace cookbook {

/** The solid {x : z <= 0} of its body frame, for static bodies. */
struct HalfSpace {};

/** A point mass, which has no volume: it does not turn, and meets only static boxes and
 half-spaces, which it does not enter on its way. */
struct Point {};

using BodyShape = std::variant<Sphere, Box, HalfSpace, Point>;

/** Where a body is and how it moves. World frame. */
struct BodyState {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< Centre of mass. [m]
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();  ///< Of the centre of mass. [m/s]
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/** What a body is when it enters a world. */
struct BodyDefinition {
  BodyShape shape = Sphere{0.5};
  BodyState state;
  double mass = 1;  ///< [kg]; 0: infinitely heavy, never moves, whatever its velocity.
  /** Principal moments along the body axes. Absent: of the solid of even density.
   [kg m²] */
  std::optional<Eigen::Vector3d> inertia;
  double restitution = 0.5;  ///< In [0, 1]; of two bodies the lesser.
  double friction = 0.6;     ///< >= 0; of two bodies the geometric mean.
  /** A constant force through the centre of mass, beside gravity. [N] */
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
  bool collides = true;  ///< False: passes through everything.
  /** Of a point: its velocity decays as exp(−drag t). [1/s], >= 0 */
  double drag = 0;
};

/** Returns the principal moments of inertia of `shape`: sphere 2/5 m r²; box with full
 sizes X, Y, Z m/12 (Y²+Z², X²+Z², X²+Y²). [kg m²]
 @pre A sphere or a box. */
Eigen::Vector3d PrincipalInertia(const BodyShape& shape, double mass);

/** Refuses a body that cannot be: not finite, not positive, a moving half-space, moments
 of inertia that no solid has (each is at most the sum of the others).
 @throws std::invalid_argument with a sentence. */
void Validate(const BodyDefinition& body);

}  // namespace cookbook
