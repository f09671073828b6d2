#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns questions that an arithmetic of unit roundoff `u` can hardly tell from
 `query`: B moved and turned by a few roundings, and, for u coarser than double, every
 number rounded. */
std::vector<ContactQuery> NeighboursOf(const ContactQuery& query, double u);

/** Returns how much the answers to the neighbours differ from the answer to the question,
 at most. A touching verdict that flips counts as the certified distance from touching.
 [m] */
double MovementOf(const ContactQuery& query, const ContactTruth& truth,
                  const ContactAnswer& answer, std::span<const ContactAnswer> neighbours);

/** Share of an error that the movement must reach to explain it: a few neighbours seldom
 include the worst one, so half. [-] */
inline constexpr double kExplains = 0.5;

/** Returns in words that `movement` explains the error of `finding`, or nothing. The
 error of a touching verdict is the certified distance from touching.
 @pre The finding is a failure. */
std::optional<std::string> PrecisionOf(const Finding& finding, const ContactTruth& truth,
                                       double movement, double u);

}  // namespace touchstone
