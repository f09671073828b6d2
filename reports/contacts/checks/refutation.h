#pragma once

#include "reports/finding/proof.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns the value midway through an enclosure. */
double MiddleOf(const Enclosure& enclosure);

/** Makes the certified plane the refutation of `claim`. */
Proof ByPlane(const ContactTruth& truth, Proof claim);

/** Makes the certified translation the refutation of `claim`. */
Proof ByTranslation(const ContactTruth& truth, Proof claim);

/** Makes the least length of a translation the refutation of `claim`. */
Proof ByNoTranslation(const ContactTruth& truth, Proof claim);

/** Refutes a separation along a direction that is smaller than it can be: by the plane if
 the bodies are apart, else by the translation. */
Proof ByPlaneOrTranslation(const ContactTruth& truth, Proof claim);

}  // namespace touchstone
