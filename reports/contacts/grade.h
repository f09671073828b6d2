#pragma once

#include "reports/finding/finding.h"
#include "reports/measures/invalidity.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the value of a finding on `query` as a share of its size. Lengths are divided
 by the greatest extent of the smaller body. A wrong hit or miss has the certified
 |separation|, divided likewise. Angles [rad], fractions and counts are unchanged. [-] */
double ShareOf(const Finding& finding, const ContactQuery& query,
               const ContactTruth& truth);

/** Returns the grade of a fault in the answer to `query`, by its share. A wrong hit or
 miss beyond rounding has a grade of its own. A fault without a size, such as a missing or
 repeated contact, is kLarge at most. */
Grade GradeOf(const Finding& finding, const ContactQuery& query,
              const ContactTruth& truth);

/** Returns the grade of an invalid answer: by how much a normal is off unit length, if
 that is all; else kUnusable. */
Grade GradeOf(const Invalidity& invalidity);

}  // namespace touchstone
