#pragma once

#include <string>

#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** The part of a program that compares the engine's answer with the truth. */
struct FaultCheck {
  std::string definitions;  ///< At namespace scope.
  /** Statements that print the truth and set `double error`, from `answer`. NaN and
   larger than the tolerance mean that the fault is there. */
  std::string statements;
};

/** Throws CannotReproduce if the verdict of `finding` is not that of a wrong answer. */
void RefuseVerdict(const Finding& finding);

/** Returns the check of `finding`. Its formula is that of the measure, in plain double
 arithmetic; the truth is the referee's certified enclosure. Throws CannotReproduce if the
 verdict or the measure has no check. */
FaultCheck CheckOf(const Finding& finding, const ContactQuery& query,
                   const ContactTruth& truth);

}  // namespace touchstone
