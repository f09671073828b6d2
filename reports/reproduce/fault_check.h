#pragma once

#include <string>

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"

namespace touchstone {

/** The part of a program that compares the engine's answer with the truth. */
struct FaultCheck {
  std::string definitions;  ///< At namespace scope.
  /** Statements that print the truth and set `double error`, from `answer`. NaN and
   larger than the tolerance mean that the fault is there. */
  std::string statements;
  /** The answers that can have the fault, as a C++ expression of `answer`. An engine that
   is corrected may decide otherwise, and then need not give the numbers. */
  std::string applies = "true";
  /** The same in words, after "an answer that says". */
  std::string applies_to = {};
  /** The tolerance as a C++ expression of `answer`; that of the finding if empty. */
  std::string allowed = {};
};

/** Returns whether the finding is that the engine did not answer the question itself: a
 crash or a hang. */
bool IsWithoutAnswer(const Finding& finding);

/** Returns the check of `finding`, one of the first oracle of `result`, which is
 `oracle`. Its formula is that of the measure, in plain double arithmetic, or a lower
 bound of it; the truth is the referee's certified enclosure. An invalid answer is checked
 for the number that is not one, or for the length of its normal. Throws CannotReproduce
 if the verdict or the measure has no check. */
FaultCheck CheckOf(const Finding& finding, const ScenarioResult& result,
                   const OracleInfo& oracle);

}  // namespace touchstone
