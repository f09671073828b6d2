#pragma once

#include <optional>

#include "reports/worlds/law_support/law.h"
#include "scenarios/worlds/motion_expectation.h"

namespace touchstone {

/** Judges a motion by what its author expects of it. Its proof says what was expected,
 when, and what the motion did.

 A touch is seen where the engine reports an impulse between the two, or where they come
 so near that they meet before the next sample. So to the stated tolerance of a touch or a
 topple the time between samples is added, and to that of a touch one step more: contacts
 may act a step late. @pre The expectation has no faults in the world. */
LawFinding JudgeExpectation(const Motion& motion, const MotionExpectation& expectation);

/** Returns the statement in place of `expectation` that the motion meets exactly: its own
 place, angle, moment. So the error of another motion by it is what the two differ by.
 Nothing for rest: motions that do not rest agree in nothing. */
std::optional<MotionExpectation> MetBy(const Motion& motion,
                                       const MotionExpectation& expectation);

}  // namespace touchstone
