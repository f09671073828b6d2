#pragma once

#include "oracles/contact_answer.h"
#include "oracles/oracle.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns whether the normal of an answer claims to be the direction of the least
 translation, or of the distance. If the bodies are apart and no distance is promised, any
 separating direction is right. */
inline bool ClaimsLeastDirection(const ContactTruth& truth, const Capability& capability,
                                 const ContactAnswer& answer) {
  return answer.touching || capability.distance || !(truth.separation.lo > 0);
}

}  // namespace touchstone
