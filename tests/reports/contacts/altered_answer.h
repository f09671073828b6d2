#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "oracles/contact_answer.h"
#include "reports/contacts/tolerances.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {

/** A question with its right answer, which an alteration changes. */
struct RightlyAnswered {
  const ContactQuery& query;
  const ContactTruth& truth;
  const Tolerances& tolerances;
  const ContactAnswer& right;
  double unit_roundoff;  ///< Unit roundoff of the engine that answers.
};

/** Returns the right answer to `query`, with every field. Contacts lie at the corners of
 the patch, drawn to its middle until both bodies reach as deep there; witness points at
 the first contact. Empty where the truth is too wide to know it, or the tolerance too
 coarse to tell right from wrong. */
std::optional<ContactAnswer> RightAnswerOf(const ContactQuery& query,
                                           const ContactTruth& truth,
                                           const Tolerances& tolerances);

/** An alteration of a right answer. */
struct Alteration {
  std::string_view name;
  /** Returns the altered answer; empty where the alteration does not apply, or would
   change too little to matter. */
  std::optional<ContactAnswer> (*apply)(const RightlyAnswered&, RandomScene&);
};

/** Returns the alterations that make a right answer wrong, each by at least ten times the
 tolerance of what it changes. */
std::span<const Alteration> WrongAlterations();

/** Returns the alterations that leave an answer right. */
std::span<const Alteration> LegalAlterations();

}  // namespace touchstone
