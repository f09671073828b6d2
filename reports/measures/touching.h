#pragma once

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns 1 if the truth is decided and the answer contradicts it, otherwise 0. [-] A
 separating plane proves the shapes apart, a point in both shapes proves them touching;
 zero separation counts as touching. Source: the separating-hyperplane theorem, Boyd &
 Vandenberghe, Convex Optimization, §2.5.1. */
double TouchingError(const ContactTruth& truth, const ContactAnswer& answer);

}  // namespace touchstone
