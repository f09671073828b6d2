#pragma once

#include <random>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A query whose answer is known by construction. */
struct ConstructedContact {
  ContactQuery query;
  Eigen::Vector3d n_AB_W;  ///< The unique best normal.
  double separation;       ///< Signed: < 0 penetrating. [m]
  /** A point on the plane midway between the two facing features. World frame, [m]. */
  Eigen::Vector3d p_WM;
};

/** Puts a feature of B against a feature of A at the given separation along their common
 normal. The bodies are rotated about the normal and, if one of the two features is flat,
 shifted across it. The pair as a whole is at no special orientation.

 The features, in the body frame, are the +z face of a box, the flank of a capsule, the
 flat end of a cylinder or cone, a face of a hull (a cuboid), and the plane of a
 half-space. All are some tenths of a metre wide, so that for |separation| of millimetres
 no other direction is as short. At most one of the two is a half-space. */
ConstructedContact PutTogether(ShapeKind a, ShapeKind b, double separation);

/** Returns every ordered pair of kinds. */
std::vector<std::pair<ShapeKind, ShapeKind>> AllPairs();

/** Returns a shape of random size, about 0.2 m to 1 m from centre to surface. */
Shape RandomShape(ShapeKind kind, std::mt19937_64& random);

/** Returns a pose with a uniformly random rotation and coordinates within ±`reach`. [m]
 */
Pose RandomPose(double reach, std::mt19937_64& random);

/** Tolerances for an answer against a constructed truth. */
struct Allowed {
  double length;  ///< Error of the separation and of the witness points. [m]
  double angle;   ///< Error of the normal. [rad]
  double point;   ///< Distance of a deepest contact from the midway plane. [m]
};

/** Expects `answer` to agree with `truth` in touching and in every field it has. */
void ExpectMatches(const ContactAnswer& answer, const ConstructedContact& truth,
                   const Allowed& allowed);

}  // namespace touchstone
