#pragma once

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns how much deeper than the truth a contact is, as far as it is proved. [m]

 max(0, −s − depth*): nothing overlaps more than the depth along the best direction, so a
 deeper contact pushes the bodies apart; a shallower one is legal.
 Source: design.md, "Measures"; MuJoCo counts the same as `overdeep`,
 test/engine/engine_collision_box_fuzz_test.cc:257-272. */
double ContactTooDeep(const ContactTruth& truth, const ContactPoint& contact);

}  // namespace touchstone
