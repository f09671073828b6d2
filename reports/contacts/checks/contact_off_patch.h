#pragma once

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

class JudgedAnswer;

/** Returns the distance of a contact from the true contact patch, across the normal. [m]
 It is the distance from a convex polygon, both seen along `n_AB_W`. Applies to deepest
 contacts only: shallower ones of a tilted manifold may legally lie elsewhere. Source: by
 definition of the patch, reports/referee/contact_truth.h.
 @pre The patch has a vertex; `n_AB_W` is a unit vector. */
double ContactOffPatch(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                       const ContactPoint& contact);

/** Returns the vector from the nearest point of the patch to a contact, across the
 normal; zero for a contact in the patch. [m] No point of the patch is farther along it,
 which proves the distance.
 @pre As for ContactOffPatch(). */
Eigen::Vector3d OffsetFromPatch(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                                const ContactPoint& contact);

/** Judges the positions of the deepest contacts. Applies where the normal is right, since
 a patch belongs to a normal, and where the truth is narrow enough to identify the deepest
 contacts. */
void CheckContactsInPatch(JudgedAnswer& judged);

}  // namespace touchstone
