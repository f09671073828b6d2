#pragma once

#include <optional>
#include <span>
#include <string>
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

/** A neighbour of a question, the answer to it, and how that is judged. */
struct JudgedNeighbour {
  ContactTruth truth;             ///< The truth of the neighbour.
  ContactAnswer answer;           ///< Its answer.
  std::vector<Finding> findings;  ///< JudgeAnswer() of the answer.
};

/** Returns the neighbours that were answered, judged. `queries`, `truths` and `answers`
 belong together. */
std::vector<JudgedNeighbour> Judged(const Scenario& scenario, const OracleInfo& oracle,
                                    std::span<const ContactQuery> queries,
                                    std::span<const ContactTruth> truths,
                                    std::span<const ContactAnswer> answers);

/** The fraction of an error that a movement must reach to explain it. It is a half
 because a few neighbours seldom include the worst one. [-] */
inline constexpr double kExplains = 0.5;

/** Returns a sentence if rounding explains the error of `finding`, otherwise nothing. It
 does in two cases. Rounding the question moves the truth by half the error or more. Or
 an answer is right where the question is moved by roundings: for a comparison with the
 referee, a neighbour passes the same measure; for a comparison of an answer with that to
 a changed question, a neighbour without any failure differs from `answer` by half the
 error or more.
 @pre The finding is a failure. */
std::optional<std::string> PrecisionOf(const Finding& finding, const ContactQuery& query,
                                       const ContactTruth& truth,
                                       const ContactAnswer& answer,
                                       std::span<const JudgedNeighbour> neighbours,
                                       double u);

}  // namespace touchstone
