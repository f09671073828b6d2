#pragma once

#include <span>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns the contacts that are missing from, or repeated in, a manifold, the larger.
 [-]

 Missing: what it has less than the fewest that span the patch. Repeated: contacts nearer
 than `same` [m] to an earlier one, which would push twice where the bodies touch once.
 Source: the least numbers are those of the patch, a point 1, a segment 2, a face 3 or 4.
 */
int ContactCountError(const ContactPatch& patch, std::span<const ContactPoint> contacts,
                      double same);

}  // namespace touchstone
