#pragma once

#include <string>

#include "reports/reproduce/fault_check.h"
#include "reports/reproduce/fault_subject.h"

namespace touchstone {

/** Returns whether the answers that a check applies to are those that say `touching`, as
 a C++ expression of `answer`. */
std::string SaysTouching(bool touching);

/** Returns the check of answers that decide as `answer` does. */
FaultCheck OfAnswersLike(const ContactAnswer& answer, std::string definitions = "",
                         std::string statements = "");

/** Returns `check` for those of its answers that have nearest points: an engine that
 gives none is not wrong about them, and `Answer` then has zeros. */
FaultCheck OfNearestPoints(FaultCheck check);

/** The definitions of the vector operations that the checks of contacts use: Along(),
 Dot() and Unit(). */
std::string VectorText();

/** Each function below returns the check of the measure of that name. The formula is that
 of the measure, and the program evaluates it for all contacts of the answer. Each throws
 CannotReproduce if a body has no closed form that the check needs. */
FaultCheck SurfaceErrorCheck(const FaultSubject& subject);
FaultCheck ContactSeparationCheck(const FaultSubject& subject);
FaultCheck TooDeepCheck(const FaultSubject& subject);
FaultCheck MixedNormalsCheck(const FaultSubject& subject);
FaultCheck WitnessErrorCheck(const FaultSubject& subject);

}  // namespace touchstone
