#pragma once

#include <string>

#include "reports/shrink/shrink.h"

namespace touchstone {

/** Returns `shrunk` as a scenario of its own, whose id is that of `original` with
 "_shrunk". It indicts the oracle, so that a run of its file confirms the fault, and fails
 if the fault is gone. */
Question ScenarioOf(const Shrunk& shrunk, const Question& original);

/** Returns the text of its file, with a header that says what was tried, what was found,
 and how to repeat it. */
std::string FileOf(const Shrunk& shrunk, const Question& original);

}  // namespace touchstone
