#pragma once

#include "reports/run.h"

namespace touchstone {

/** Adds a fault for every statement of a scenario that the run refutes: an expectation
 that the certified truth contradicts, and an indictment that is not found again, or found
 although the scenario says that it is fixed.

 An indictment is found where a finding against the referee, for its oracle, is `fail`,
 `known`, `invalid`, `crashed` or `timed out`; metamorphic findings are of other questions
 and count neither way. Oracles that did not take part are not asked after. */
void CheckCatalogue(RunReport& report);

/** What a value derived by hand and written with ten digits may be off by, relative to
 * itself. */
inline constexpr double kWritten = 1e-9;

}  // namespace touchstone
