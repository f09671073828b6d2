#pragma once

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Computes the certified truth of `query`. For polytopes, spheres and capsules it
 evaluates exact candidates (face normals, edge crosses, feature pairs) under a running
 error bound, and uses higher precision (MPFR) only where the bound cannot decide. For
 cylinders and cones it narrows certified lower and upper bounds; where they do not meet,
 the enclosure stays wide.

 The truth refers to the affine image of each shape for the exact doubles of its pose.
 Deterministic and thread safe.
 @pre `query` is valid (scenarios/validate.h) and not two half-spaces. */
ContactTruth ComputeContactTruth(const ContactQuery& query);

/** Returns whether doubles prove two bounded shapes apart, along the direction that a
 search in doubles finds: a fraction of the work of ComputeContactTruth(), which proves
 them apart, too. Says nothing if it returns false.
 @pre `query` is valid. */
bool AreProvedApart(const ContactQuery& query);

/** Returns an enclosure of the overlap o(n) = max_A n·x − min_B n·x along the unit vector
 that `n_W` normalises to. Moving B by o(n) along n just separates the shapes, so o(n) is
 an upper bound on the depth for every n. A negative overlap is a gap, and proves the
 shapes apart. [m]
 @pre `n_W` is finite and not zero. A half-space has infinite overlap along every
 direction except its own normal: the enclosure is then [inf, inf]. */
Enclosure Overlap(const ContactQuery& query, const Eigen::Vector3d& n_W);

/** Returns an enclosure of the signed distance of the point `p_W` from the surface of
 `body`, negative inside. [m] */
Enclosure SignedDistance(const Body& body, const Eigen::Vector3d& p_W);

/** Returns the true contact patch along `n_W`, given that B just touches A once it is
 moved by `separation` against n_W. Features within `slack` [m] of the supporting plane
 belong to the patch. `vertices_W` is in the plane midway through the overlap. */
ContactPatch PatchAlong(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation, double slack);

/** Returns the part of the contact patch along `n_W` that a computation must not miss if
 its lengths are off by at most `e` [m].

 If features within e of their supporting planes lie flat along a direction near n_W, then
 n_W is a rounding of that direction, and the patch is taken along it: along n_W itself a
 face would appear tilted. Then only features within `flush` [m] count, which is the
 rounding of the question and not of the answer.

 A feature that is tilted by more than `flush` and less than e is flat to a computation,
 any point of which is then as deep as the lowest corner, edge or arc. One point of the
 patch is certain.

 Corners that stick out by no more than kBlurred e are left out, since an engine may merge
 them: a sliver becomes a segment, a speck a point. */
ContactPatch CertainPatch(const ContactQuery& query, const Eigen::Vector3d& n_W,
                          double separation, double flush, double e);

/** The ratio of a corner's protrusion to e below which CertainPatch() leaves it out:
 sides that move by e take about a tenth of a polygon whose corners stick out by 16 e, see
 PatchBlur(). [-] */
inline constexpr double kBlurred = 16;

}  // namespace touchstone
