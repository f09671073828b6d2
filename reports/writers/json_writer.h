#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Writes all of `report` as JSON that follows docs/report.schema.json. Numbers round
 trip; non-finite numbers are the strings "NaN", "Infinity" and "-Infinity". The same
 report gives the same bytes. */
void WriteJson(const RunReport& report, std::ostream& out);

}  // namespace touchstone
