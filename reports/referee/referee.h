#pragma once

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Computes the certified truth of `query`.

 Polytopes, spheres and capsules: exact candidates (face normals, edge crosses, feature
 pairs) under a running error bound, decided at higher precision (MPFR) only where the
 bound cannot. Cylinders and cones: certified lower and upper bounds that are driven
 together; where they do not meet, the enclosure stays wide and says so.

 The question is the affine image of each shape under the doubles of its pose.
 Deterministic, thread safe.
 @pre `query` is valid (scenarios/validate.h) and not two half-spaces. */
ContactTruth JudgeContact(const ContactQuery& query);

/** Returns an enclosure of the overlap o(n) = max_A n·x − min_B n·x along the unit vector
 that `n_W` normalises to: moving B by o(n) along n just separates the shapes (a negative
 overlap is a gap, and proves them apart). An upper bound on the depth for every n. [m]
 @pre `n_W` is finite and not zero. A half-space has infinite overlap along all but its
 own normal: the enclosure is then [inf, inf]. */
Enclosure Overlap(const ContactQuery& query, const Eigen::Vector3d& n_W);

/** Returns an enclosure of the signed distance of the point `p_W` from the surface of
 `body`: negative inside. [m] */
Enclosure SignedDistance(const Body& body, const Eigen::Vector3d& p_W);

/** Returns the true contact patch along `n_W`, given that B moved by `separation` against
 it just touches A. Features within `slack` [m] of the supporting plane belong to the
 patch. `vertices_W` is in the plane midway through the overlap. */
ContactPatch PatchAlong(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation, double slack);

/** Returns what of the contact patch along `n_W` no computation may miss whose lengths
 are off by `e` [m].

 Where features within e of their supporting planes lie flat along a direction near n_W,
 that direction is the one which n_W is a rounding of, and the patch is taken along it:
 along n_W itself a face would be seen tilted. Only features within `flush` [m] then
 count, which is the rounding of the question and not of the answer: a tilt beyond it may
 be taken at its word, and the patch is then the lowest corner. Corners that stick out by
 no more than kBlurred e are left out, as they may be merged: a sliver is a segment, a
 speck a point. */
ContactPatch CertainPatch(const ContactQuery& query, const Eigen::Vector3d& n_W,
                          double separation, double flush, double e);

/** Moved by e, the sides of a polygon whose corners stick out by 16 e take about a tenth
 of it, see PatchBlur(). [-] */
inline constexpr double kBlurred = 16;

}  // namespace touchstone
