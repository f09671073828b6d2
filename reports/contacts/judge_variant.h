#pragma once

#include <optional>
#include <vector>

#include "oracles/oracle.h"
#include "reports/contacts/tolerance_reasons.h"
#include "reports/contacts/tolerances.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** A changed question whose answer follows from the answer to the original question. */
struct Variant {
  MeasureKind measure;  ///< kSwap … kPerturbation.
  ContactQuery query;
  /** Ratio of the lengths of `query` to those of the question. [-] */
  double factor = 1;
  double rounding = 0;  ///< Rounding of the variant itself, see TransformedQuery. [m]
  /** Upper bound on the change of the overlap along a right normal. [m] */
  double play = 0;
};

/** Returns the metamorphic variants of a scenario's question: swapped; moved rigidly;
 scaled; with the axes of its boxes relabelled, if it has a box; with B moved by a
 millionth of the scene. Deterministic: the scenario's id selects one of the 24
 labellings. */
std::vector<Variant> VariantsOf(const Scenario& scenario);

/** Judges the answer to a variant against the answer to the question itself. Empty where
 there is nothing to compare: both answers say only whether the bodies touch, and either
 may be right so near to touching.
 `reasons` chooses the findings that carry Finding::tolerance_because.
 @param tolerances TolerancesOf() the answer to the question.
 @pre `answer` is valid, see reports/measures/invalidity.h. */
std::optional<Finding> JudgeVariant(const Scenario& scenario, const ContactTruth& truth,
                                    const OracleInfo& oracle, const ContactAnswer& answer,
                                    const Variant& variant,
                                    const ContactAnswer& variant_answer,
                                    const Tolerances& tolerances,
                                    Reasons reasons = Reasons::kOfAll);

}  // namespace touchstone
