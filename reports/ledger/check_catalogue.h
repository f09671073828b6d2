#pragma once

#include "reports/run.h"

namespace touchstone {

/** Adds a fault for every statement of a scenario that the run refutes: an expectation
 that the certified truth contradicts or is too wide to check, a claim to be stable that
 each of several engines breaks, and an indictment that is not found again, or found
 although the scenario says that it is fixed.

 A measure of an indictment is found where that finding of its oracle is `fail`, `known`,
 `invalid`, `crashed` or `timed out`; what other measures find counts neither way. One
 that is said to be fixed must have been measured. Oracles that did not take part are not
 asked after. */
void CheckCatalogue(RunReport& report);

/** What a value derived by hand and written with ten digits may be off by, relative to
 * itself. */
inline constexpr double kWritten = 1e-9;

}  // namespace touchstone
