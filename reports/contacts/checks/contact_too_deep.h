#pragma once

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

class JudgedAnswer;

/** Returns the excess of a contact's depth over the true depth, as far as it is proved.
 [m] max(0, −s − depth*): no point overlaps more than the depth along the best direction.
 A deeper contact pushes the bodies apart; a shallower one is legal. Source: MuJoCo counts
 the same as `overdeep`, test/engine/engine_collision_box_fuzz_test.cc:257-272. */
double ContactTooDeep(const ContactTruth& truth, const ContactPoint& contact);

/** Judges the depth of the deepest contact. */
void CheckDeepestContact(JudgedAnswer& judged);

}  // namespace touchstone
