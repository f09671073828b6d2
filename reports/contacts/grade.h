#pragma once

#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the grade of a fault in the answer to `query`. Lengths are relative to
 the greatest extent of the smaller body. A wrong hit or miss is graded by the certified
 |separation|. A missing or repeated contact is gross. */
Grade GradeOf(const Finding& finding, const ContactQuery& query,
              const ContactTruth& truth);

}  // namespace touchstone
