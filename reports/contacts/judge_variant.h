#pragma once

#include <optional>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** A changed question whose answer follows from the answer to the question itself. */
struct Variant {
  MeasureKind measure;  ///< kSwap … kPerturbation.
  ContactQuery query;
  /** All lengths of `query` over those of the question. [-] */
  double factor = 1;
  double rounding = 0;  ///< Of the variant itself, see TransformedQuery. [m]
  /** The most by which an overlap along a right normal may move. [m] */
  double play = 0;
};

/** Returns the metamorphic variants of a scenario's question: swapped; moved rigidly;
 scaled; with the axes of its boxes relabelled, where it has a box; B moved by a millionth
 of the scene. Deterministic: which of the 24 labellings is chosen by the scenario's id.
 */
std::vector<Variant> VariantsOf(const Scenario& scenario);

/** Judges the answer to a variant against the answer to the question itself. Empty where
 there is nothing to compare: answers that say only whether the bodies touch, which may go
 either way so near to touching.
 @pre `answer` is valid, see reports/measures/invalidity.h. */
std::optional<Finding> JudgeVariant(const Scenario& scenario, const ContactTruth& truth,
                                    const OracleInfo& oracle, const ContactAnswer& answer,
                                    const Variant& variant,
                                    const ContactAnswer& variant_answer);

}  // namespace touchstone
