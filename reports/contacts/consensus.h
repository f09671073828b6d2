#pragma once

#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"

namespace touchstone {

/** Marks as `disagree` the findings of one scenario that the certified truth is too wide
 to decide and most algorithm families contradict.

 A family has one vote, however many libraries use it, and supports an answer if any of
 its members does, to within the tolerances of both. An answer disagrees if the families
 against it are at least as many as those for it, its own included. If only two differ,
 both disagree. Touching is voted on where the enclosure extends across zero by more than
 the tolerance, separation where the enclosure is wider than the tolerance. */
void SettleByConsensus(const ScenarioResult& result, std::span<const OracleInfo> oracles,
                       std::span<Finding> findings);

}  // namespace touchstone
