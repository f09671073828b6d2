#pragma once

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns how far a contact lies outside the true contact patch, across the normal. [m]

 A convex polygon's distance, both seen along `n_AB_W`. Applies to deepest contacts only:
 shallower ones of a tilted manifold lie legally elsewhere.
 Source: by definition of the patch, reports/referee/contact_truth.h.
 @pre The patch has a vertex; `n_AB_W` is a unit vector. */
double ContactOffPatch(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                       const ContactPoint& contact);

}  // namespace touchstone
