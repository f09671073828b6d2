#pragma once

#include "scenarios/contact_query.h"

namespace touchstone {

/** A query derived from another, such that a law connects the two answers. The law holds
 for the truth, so it must hold for every oracle; no reference is needed. */
struct TransformedQuery {
  ContactQuery query;
  /** The amount by which the true separation may deviate from the law, because the query
   itself was rounded. 0 if the transformation is exact. [m] */
  double rounding;
};

/** Exchanges A and B. Exact.
 Law: the separation is unchanged, n_AB_W is negated, witnesses are exchanged. */
TransformedQuery Swapped(const ContactQuery& query);

/** Moves both bodies by `X_MW`: x_M = R_MW x_W + p_MW. Both poses become matrices.
 Law: the separation is unchanged; normals are rotated by R_MW, points moved by X_MW.
 @pre X_MW.R_WB (R_MW) is a rotation up to kRotationSlack; `rounding` includes its
 deviation. */
TransformedQuery MovedRigidly(const ContactQuery& query, const Pose& X_MW);

/** Multiplies all sizes and positions by `factor`. Exact for a power of two, as long as
 nothing leaves the range of normal doubles. Law: the separation and all points are
 multiplied by `factor`; normals are unchanged.
 @pre factor is finite and > 0. */
TransformedQuery Scaled(const ContactQuery& query, double factor);

/** Relabels a box's axes: the same solid at the same position, its extents permuted and
 the columns of its rotation permuted and negated by CubeRotation(symmetry). Exact. A body
 that is not a box is returned unchanged.
 Law: the answer is unchanged.
 @pre 0 <= symmetry < kCubeRotations. */
Body Relabelled(const Body& body, int symmetry);

/** Relabels the axes of A by `symmetry_A` and those of B by `symmetry_B`. Exact. */
TransformedQuery Relabelled(const ContactQuery& query, int symmetry_A, int symmetry_B);

/** Moves B by `offset_W`.
 Law: the separation changes by at most |offset_W|, since the distance and the depth of
 convex sets are 1-Lipschitz in a translation of one of them. */
TransformedQuery Perturbed(const ContactQuery& query, const Eigen::Vector3d& offset_W);

}  // namespace touchstone
