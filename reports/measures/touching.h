#pragma once

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns 1 if the truth is decided and the answer says otherwise, else 0. [-]

 Apart is proved by a separating plane, touching by a point in both shapes; zero
 separation counts as touching. Source: the separating-hyperplane theorem, Boyd &
 Vandenberghe, Convex Optimization, §2.5.1. */
double TouchingError(const ContactTruth& truth, const ContactAnswer& answer);

}  // namespace touchstone
