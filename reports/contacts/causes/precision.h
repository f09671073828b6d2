#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns questions that an arithmetic of unit roundoff `u` can hardly distinguish from
 `query`: B moved and turned by a few roundings. If u is coarser than double, also the
 query with every number rounded to float. */
std::vector<ContactQuery> NeighboursOf(const ContactQuery& query, double u);

/** Returns the largest difference between the answer to the question and the answers to
 its neighbours. A touching verdict that flips counts as the certified distance from
 touching. [m] */
double MovementOf(const ContactQuery& query, const ContactTruth& truth,
                  const ContactAnswer& answer, std::span<const ContactAnswer> neighbours);

/** The fraction of an error that the movement must reach to explain it. It is a half
 because a few neighbours seldom include the worst one. [-] */
inline constexpr double kExplains = 0.5;

/** Returns a sentence if `movement` explains the error of `finding`, otherwise nothing.
 The error of a touching verdict is the certified distance from touching.
 @pre The finding is a failure. */
std::optional<std::string> PrecisionOf(const Finding& finding, const ContactTruth& truth,
                                       double movement, double u);

}  // namespace touchstone
