#pragma once

#include <span>

#include "oracles/contact_answer.h"

namespace touchstone {

/** Returns the number of missing or of repeated contacts of a manifold, whichever is
 larger. [-] Missing: `least`, the fewest contacts that span the patch, minus those there
 are; 0 if their hull holds the patch already.
 Repeated: contacts nearer than `same` [m] to an earlier one, which would apply two
 impulses where the bodies touch once. Source: the fewest contacts of the patch are 1 for
 a point, 2 for a segment, 3 or 4 for a face. */
int ContactCountError(int least, std::span<const ContactPoint> contacts, double same);

}  // namespace touchstone
