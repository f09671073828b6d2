#pragma once

#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** Judges one answer against the certified truth: one finding per measure that applies,
 in the order of MeasureKind.

 A verdict is `pass`, `fail` with a proof, or `undecidable` where the truth itself is.
 What is outside the enclosure of the truth by more than the derived tolerance is proved
 wrong; nothing inside it is, see reports/contacts/consensus.h. Nor is anything inside an enclosure
 wider than the tolerance right, but what the whole of the enclosure is near. An answer
 that is invalid is judged no further. */
std::vector<Finding> JudgeAnswer(const Scenario& scenario, const ContactTruth& truth,
                                 const OracleInfo& oracle, const ContactAnswer& answer);

}  // namespace touchstone
