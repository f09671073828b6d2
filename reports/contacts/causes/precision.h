#pragma once

#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** Returns questions that an arithmetic of unit roundoff `u` can hardly distinguish from
 `query`: B moved and turned by a few roundings. If u is coarser than double, also the
 query with every number rounded to float. */
std::vector<ContactQuery> NeighboursOf(const ContactQuery& query, double u);

/** Returns whether the answer that failed may be right for a neighbour of its question.
 A length changes no faster than the bodies move, so a failure beyond a tolerance of 64
 roundings stays one; except at a touch, where other measures apply on either side. What
 is compared with the patch may jump, since the patch does where faces become flush. */
bool RoundingMayExplain(const Finding& finding, const ContactQuery& query,
                        const ContactTruth& truth, double u);

/** Sets the cause `precision` on those failures without a cause that an answer would not
 have if a neighbour had been asked: all that a stable algorithm promises is the right
 answer to a question that differs by roundings. Source: N. J. Higham, Accuracy and
 Stability of Numerical Algorithms, 2nd ed., section 1.5.
 @param neighbours NeighboursOf() the question, at the roundoff of the oracle.
 @param truths Their truths. */
void ExplainByRounding(const Scenario& scenario, const OracleInfo& oracle,
                       const ContactAnswer& answer,
                       std::span<const ContactQuery> neighbours,
                       std::span<const ContactTruth> truths, std::span<Finding> findings);

}  // namespace touchstone
