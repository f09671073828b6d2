#pragma once

#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the grade of a fault in the answer to `query`. The size of a length is that
 relative to the greatest extent of the smaller body. A wrong answer whether the bodies
 touch is as large as the certified distance from touching. A missing or repeated contact
 is gross. */
Grade GradeOf(const Finding& finding, const ContactQuery& query,
              const ContactTruth& truth);

}  // namespace touchstone
