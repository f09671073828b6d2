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
  std::vector<Finding> findings;  ///< JudgeAnswer() of the answer, of wanted measures.
};

/** Returns the neighbours that were answered, judged by what ExplanationByRounding()
 asks of them for the failures among `findings`. `queries`, `truths` and `answers` belong
 together. */
std::vector<JudgedNeighbour> Judged(const Scenario& scenario, const OracleInfo& oracle,
                                    std::span<const ContactQuery> queries,
                                    std::span<const ContactTruth> truths,
                                    std::span<const ContactAnswer> answers,
                                    std::span<const Finding> findings);

/** The fraction of an error that a movement must reach to explain it. It is a half
 because a few neighbours seldom include the worst one. [-] */
inline constexpr double kExplains = 0.5;

/** The cause of an error, and the sentence that says why. */
struct Explanation {
  Cause cause;
  std::string because;
  bool moves_truth = false;  ///< Whether rounding moves the truth that far.
};

/** Returns what roundings of the question say about the error of `finding`, or nothing.
 It is `precision` in two cases. Rounding the question moves the truth by half the error
 or more. Or an answer is right where the question is moved by roundings: for a comparison
 with the referee, a neighbour passes the same measure; for a comparison of an answer with
 that to a changed question, a neighbour without any failure differs from `answer` by half
 the error or more. In the second case an error against the referee above a tenth of the
 smaller body is a defect: a stable algorithm returns the truth of a question that differs
 by roundings, and no such truth is near the answer. Source: N. J. Higham, Accuracy and
 Stability of Numerical Algorithms, 2nd ed., section 1.5.
 @pre The finding is a failure. */
std::optional<Explanation> ExplanationByRounding(
    const Finding& finding, const ContactQuery& query, const ContactTruth& truth,
    const ContactAnswer& answer, std::span<const JudgedNeighbour> neighbours, double u);

}  // namespace touchstone
