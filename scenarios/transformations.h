#pragma once

#include "scenarios/contact_query.h"

namespace touchstone {

/** A question made from another so that the two answers are bound by a law, which holds
 for the truth and so must for every oracle. No reference is needed. */
struct TransformedQuery {
  ContactQuery query;
  /** By how much the true separation may miss the law, because the question itself had to
   be rounded. 0 where the transformation is exact. [m] */
  double rounding;
};

/** Exchanges A and B. Exact.
 Law: the separation is the same, n_AB_W is negated, witnesses are exchanged. */
TransformedQuery Swapped(const ContactQuery& query);

/** Moves both bodies by `X_MW`: x_M = R_MW x_W + p_MW. Both poses become matrices.
 Law: the separation is the same; normals are turned by R_MW, points moved by X_MW.
 @pre X_MW.R_WB (R_MW) is a rotation, up to kRotationSlack; what it lacks is in
 `rounding`. */
TransformedQuery MovedRigidly(const ContactQuery& query, const Pose& X_MW);

/** Multiplies all sizes and positions by `factor`. Exact for a power of two, as long as
 nothing leaves the range of normal doubles. Law: the separation is multiplied by
 `factor`, points too; normals are the same.
 @pre factor is finite and > 0. */
TransformedQuery Scaled(const ContactQuery& query, double factor);

/** Names a box's axes otherwise: the same solid in the same place, its extents permuted
 and the columns of its rotation permuted and negated by CubeRotation(symmetry). Exact.
 Law: the answer is the same.
 @pre 0 <= symmetry < kCubeRotations. A body that is no box is left as it is. */
Body Relabelled(const Body& body, int symmetry);

/** Relabels the axes of A by one symmetry and those of B by another. Exact. */
TransformedQuery Relabelled(const ContactQuery& query, int symmetry_A, int symmetry_B);

/** Moves B by `offset_W`.
 Law: the separation changes by at most |offset_W|, since the distance and the depth of
 convex sets are 1-Lipschitz in a translation of one of them. */
TransformedQuery Perturbed(const ContactQuery& query, const Eigen::Vector3d& offset_W);

}  // namespace touchstone
