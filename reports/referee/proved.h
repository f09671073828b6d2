#pragma once

#include "reports/referee/contact_truth.h"
#include "reports/referee/core_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns the enclosure of the separation that the certificate in `core` proves. The
 bounds are evaluated from the query, by formulas that the searches do not use:
 - from below, minus the overlap of both shapes along the direction of the certificate,
 - from above, the distance of its points, each of which must be in its shape, or the
 proof of the depth if the shapes penetrate.
 A certificate that proves less than the search claims gives a wider enclosure. If both
 bounds contradict each other, one of the proofs is wrong: nothing is proved, and the
 enclosure is unbounded. [m]
 @pre Neither body is a half-space. */
template <typename Real>
Enclosure Proved(const ContactQuery& query, const CoreTruth<Real>& core);

}  // namespace touchstone::referee
