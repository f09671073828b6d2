#pragma once

#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"

namespace touchstone {

/** Sets the causes that the answers themselves show, on the findings of one scenario and
 one oracle. A failure may be due to a convention; a pass may be due to a tie of normals,
 or to a documented model without which it would fail. */
void ExplainByAnswer(const ScenarioResult& result, const OracleInfo& oracle,
                     const ContactAnswer& answer, std::span<Finding> findings);

/** Returns whether a failure still has no cause, so that querying the oracle again may
 find one. */
bool IsUnexplained(const Finding& finding);

/** Sets the cause `precision` on those failures of one scenario and one oracle whose
 error is no larger than the change that a few roundings of the input make to the answer.
 */
void ExplainByNeighbours(const ScenarioResult& result, const OracleInfo& oracle,
                         const ContactAnswer& answer,
                         std::span<const ContactAnswer> neighbours,
                         std::span<Finding> findings);

/** Sets the cause of all remaining failures: a margin where many share one error,
 otherwise a defect. Unproved differences keep no cause. */
void ExplainTheRest(std::span<const ScenarioResult> results,
                    std::span<const OracleInfo> oracles, std::span<Finding> findings);

}  // namespace touchstone
