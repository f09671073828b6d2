#pragma once

#include <span>

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"

namespace touchstone {

// Causes that one answer cannot show, settled by all answers of a run. `findings` are
// those of all oracles to all questions.

/** Sets the cause of failed separations that a margin explains, see ExplainByMargin(). */
void ExplainByMargins(std::span<const ScenarioResult> results,
                      std::span<const OracleInfo> oracles, std::span<Finding> findings);

/** Turns conventions into defects that only one geometry shows, or that the same oracle
 contradicts: in a question with the same kinds of shapes, apart or penetrating alike, the
 same measure passes as it is. A convention that only one geometry shows is not examined
 if such questions have failures that are not: another of them may show it. */
void RefuseConventions(std::span<const ScenarioResult> results,
                       std::span<const OracleInfo> oracles, std::span<Finding> findings);

}  // namespace touchstone
