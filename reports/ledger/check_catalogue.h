#pragma once

#include "reports/run_report.h"

namespace touchstone {

/** Adds a fault for every statement of a scenario that the run refutes. A fault is an
 expectation that the certified truth contradicts, or is too wide to check; a claim to be
 stable that each of several engines breaks; an indictment that is not reproduced, or is
 reproduced although the scenario says that it is fixed.

 An indicted measure is reproduced where the oracle's finding for it is `fail`, `known`,
 `invalid`, `crashed` or `timed out`; other measures do not count. A measure said to be
 fixed must have been measured. Indictments of oracles that did not take part are skipped.
 */
void CheckCatalogue(RunReport& report);

/** The relative error allowed for a value derived by hand and written with ten digits.
 [-] */
inline constexpr double kWritten = 1e-9;

}  // namespace touchstone
