#pragma once

#include "reports/reproduce/fault_check.h"
#include "reports/reproduce/fault_subject.h"

namespace touchstone {

/** Each function below returns the check of the measure of that name. The patch belongs
 to the normal of the recorded answer, so a program checks answers of that normal alone.
 It knows a point of the patch and a direction, along which it compares the contacts: a
 projection proves a distance, and equals that of the recorded answer. Each throws
 CannotReproduce if no such point proves the fault. */
FaultCheck OffPatchCheck(const FaultSubject& subject);
FaultCheck CoverageCheck(const FaultSubject& subject);
FaultCheck CountCheck(const FaultSubject& subject);

}  // namespace touchstone
