#pragma once

#include <span>
#include <vector>

#include "reports/finding/finding.h"
#include "reports/run.h"

namespace touchstone {

/** Sets the causes that the answers themselves show, on the findings of one scenario and
 one oracle: a convention on failures; on passes, a tie of normals, and a documented model
 where only that lets them pass. */
void ExplainByAnswer(const ScenarioResult& result, const OracleInfo& oracle,
                     const ContactAnswer& answer, std::span<Finding> findings);

/** Returns whether a failure is still without a cause that asking again might find. */
bool IsUnexplained(const Finding& finding);

/** Sets the cause `precision` on the failures of one scenario and one oracle whose error
 is no larger than what a few roundings of the input do to the answer. */
void ExplainByNeighbours(const ScenarioResult& result, const OracleInfo& oracle,
                         const ContactAnswer& answer,
                         std::span<const ContactAnswer> neighbours,
                         std::span<Finding> findings);

/** Sets the cause of all failures that are left: a margin where many share one error,
 else a defect. Differences that are not proved keep no cause. */
void ExplainTheRest(RunReport& report);

}  // namespace touchstone
