#pragma once

#include <span>

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"

namespace touchstone {

/** Sets the causes that the answers themselves show, on the findings of one scenario and
 one oracle. A failure may be due to a convention; a pass may be due to a tie of normals,
 or to a documented model without which it would fail. */
void ExplainByAnswer(const ScenarioResult& result, const OracleInfo& oracle,
                     const ContactAnswer& answer, std::span<Finding> findings);

/** Settles the causes by all questions of a run. A margin is found where many share one
 error. A convention that only one geometry shows, or that another answer of the same
 oracle contradicts, is a defect. All failures without a cause are defects. Unproved
 differences keep no cause. */
void ExplainTheRest(std::span<const ScenarioResult> results,
                    std::span<const OracleInfo> oracles, std::span<Finding> findings);

}  // namespace touchstone
