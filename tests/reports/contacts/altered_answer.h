#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {

/** The errors that an engine may make, by the size of the question and the engine's unit
 roundoff alone. The judge's tolerances are not asked: if one of them grew too wide, an
 alteration that grew with it would never show it. */
struct Accuracy {
  double length = 0;  ///< Error of a length or a position along the normal. [m]
  double apart =
      0;  ///< Error of the overlap along a normal between two nearest points. [m]
  double excess =
      0;  ///< Error of the excess of a normal that was chosen among others. [m]
  double across = 0;  ///< Error of a deepest point across the normal. [m]
  double fine = 0;    ///< A hundredth of the smallest feature and of the distance. [m]
};

/** Returns the accuracy of a right answer in arithmetic of that unit roundoff: 64
 roundings of the scene and the rounding of its input for a length e; with the distance d
 and both extents E, e + E min(1, e/d) for a normal of bodies that are apart; √(8 e D)
 across a body of extent D. */
Accuracy AccuracyOf(const ContactQuery& query, const ContactTruth& truth,
                    double unit_roundoff);

/** A question with its right answer, which an alteration changes. */
struct RightlyAnswered {
  const ContactQuery& query;
  const ContactTruth& truth;
  const Accuracy& accuracy;
  const ContactAnswer& right;
  double unit_roundoff;  ///< Unit roundoff of the engine that answers.
};

/** Returns the right answer to `query`, with every field. Contacts lie at the corners of
 the patch, drawn to its middle until both bodies reach as deep there; witness points at
 the first contact. Empty where the truth is too wide to know it, or the accuracy too
 coarse to tell right from wrong. */
std::optional<ContactAnswer> RightAnswerOf(const ContactQuery& query,
                                           const ContactTruth& truth,
                                           const Accuracy& accuracy);

/** An alteration of a right answer. */
struct Alteration {
  std::string_view name;
  /** Returns the altered answer; empty where the alteration does not apply, or would
   change too little to matter. */
  std::optional<ContactAnswer> (*apply)(const RightlyAnswered&, RandomScene&);
};

/** Returns the alterations that make a right answer wrong, each by at least ten times the
 accuracy of what it changes. */
std::span<const Alteration> WrongAlterations();

/** Returns the alterations that leave an answer right. */
std::span<const Alteration> LegalAlterations();

}  // namespace touchstone
