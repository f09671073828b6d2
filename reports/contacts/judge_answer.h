#pragma once

#include <vector>

#include "oracles/oracle.h"
#include "reports/contacts/tolerance_reasons.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** Judges one answer against the certified truth: one finding per measure that
 applies, in the order of the checks.

 A verdict is `pass`, `fail` with a proof, or `undecidable` where the truth itself is. A
 value is proved wrong if it lies outside the enclosure of the truth by more than the
 derived tolerance. A value inside the enclosure is never proved wrong, see
 reports/contacts/consensus.h. If the enclosure is wider than the tolerance, a value
 passes only if it is within the tolerance of every point of it. An invalid answer is
 judged no further.
 @param reasons The findings that carry Finding::tolerance_because and a proof. */
std::vector<Finding> JudgeAnswer(const Scenario& scenario, const ContactTruth& truth,
                                 const OracleInfo& oracle, const ContactAnswer& answer,
                                 Reasons reasons = Reasons::kOfAll);

}  // namespace touchstone
