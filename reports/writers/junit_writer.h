#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Writes `report` as JUnit XML: a suite per oracle, a test case per scenario, and a
 suite for the faults of the scenario files and the ledger.

 A dashboard shows: pass and undecidable as passed; known and unsupported as skipped, each
 with its reason (as pytest writes its expected failures); proved wrong, disagreeing and
 invalid as failures; crashed and timed out as errors. `time` is SecondsOf() the answer
 or world. */
void WriteJUnit(const RunReport& report, const FailureRule& rule, std::ostream& out);

}  // namespace touchstone
