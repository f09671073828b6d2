#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Writes all of `report` as JSON Lines, each of which follows docs/report.schema.json: a
 line "run", then one for each oracle, scenario, world, finding, answer with the time that
 it took, ledger entry, fault and regression. Only the lines "seconds" differ between two
 runs of the same questions. Numbers round trip; non-finite numbers are the strings "NaN",
 "Infinity" and
 "-Infinity". The same report gives the same bytes. */
void WriteJson(const RunReport& report, std::ostream& out);

}  // namespace touchstone
