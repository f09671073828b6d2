#pragma once

#include <span>
#include <vector>

#include "reports/finding/finding.h"
#include "reports/run.h"

namespace touchstone {

/** Marks as `disagree` the findings of one scenario that the certified truth is too wide
 to decide, where most algorithm families say otherwise.

 A family votes once, however many libraries carry it, and is with an answer if any of its
 members is, to within the tolerances of both. An answer disagrees if the families against
 it are at least as many as those for it, its own included: of two that differ, both do.
 Touching is voted on where the enclosure reaches across zero by more than the tolerance,
 separation where it is wider than the tolerance. */
void SettleByConsensus(const ScenarioResult& result, std::span<const OracleInfo> oracles,
                       std::span<Finding> findings);

}  // namespace touchstone
