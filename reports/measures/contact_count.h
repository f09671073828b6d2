#pragma once

#include <span>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns the number of missing or of repeated contacts of a manifold, whichever is
 larger. [-] Missing: the fewest contacts that span the patch, minus those there are.
 Repeated: contacts nearer than `same` [m] to an earlier one, which would apply two
 impulses where the bodies touch once. Source: the fewest contacts of the patch are 1 for
 a point, 2 for a segment, 3 or 4 for a face. */
int ContactCountError(const ContactPatch& patch, std::span<const ContactPoint> contacts,
                      double same);

}  // namespace touchstone
