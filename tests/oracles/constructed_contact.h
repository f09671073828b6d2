#pragma once

#include <random>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A question whose answer is known by construction. */
struct ConstructedContact {
  ContactQuery query;
  Eigen::Vector3d n_AB_W;  ///< The one best direction.
  double separation;       ///< [m]
  /** On the plane midway between the two features that meet. World frame, [m]. */
  Eigen::Vector3d p_WM;
};

/** Puts a feature of B against a feature of A, `separation` apart along their common
 normal, spun about it, shifted across it where one of the two is flat, and turns the
 whole to no special attitude.

 The features, in the body frame: of a box the +z face, of a capsule its flank, of a
 cylinder and a cone the flat end, of a hull (a cuboid) a face, of a half-space its plane.
 All are some tenths of a metre wide, so that for |separation| of millimetres no other
 direction is as short. At most one of the two is a half-space. */
ConstructedContact PutTogether(ShapeKind a, ShapeKind b, double separation);

/** Returns every ordered pair of kinds. */
std::vector<std::pair<ShapeKind, ShapeKind>> AllPairs();

/** Returns a shape of random size, 0.2 m to 1 m from centre to surface. */
Shape RandomShape(ShapeKind kind, std::mt19937_64& random);

/** Returns a uniformly turned pose with coordinates within ±`reach`. [m] */
Pose RandomPose(double reach, std::mt19937_64& random);

/** How far an answer may be from a constructed truth. */
struct Allowed {
  double length;  ///< Of the separation and the witness points. [m]
  double angle;   ///< Of the normal. [rad]
  double point;   ///< Of a deepest contact from the midway plane. [m]
};

/** Expects `answer` to say what `truth` does: touching, and what else it gives. */
void ExpectMatches(const ContactAnswer& answer, const ConstructedContact& truth,
                   const Allowed& allowed);

}  // namespace touchstone
