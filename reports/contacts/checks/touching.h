#pragma once

#include <optional>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

class JudgedAnswer;

/** Returns whether the shapes touch, for the exact doubles of the question: certified by
 the sign of the separation, and even within the rounding of the input. Empty if the
 enclosure extends across zero. */
std::optional<bool> CertifiedTouching(const ContactTruth& truth);

/** Returns 1 if the truth is decided and the answer contradicts it, otherwise 0. [-] A
 separating plane proves the shapes apart, a point in both shapes proves them touching;
 zero separation counts as touching. Source: the separating-hyperplane theorem, Boyd &
 Vandenberghe, Convex Optimization, §2.5.1. */
double TouchingError(const ContactTruth& truth, const ContactAnswer& answer);

/** Judges whether the answer says touching or apart. Within the rounding of the input, or
 of the engine, only a scene whose numbers need no rounding decides. */
void CheckTouching(JudgedAnswer& judged);

}  // namespace touchstone
