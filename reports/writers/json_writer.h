#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Writes everything in `report` as JSON, docs/report.schema.json. Numbers round trip;
 those that JSON lacks are the strings "NaN", "Infinity" and "-Infinity". Same report,
 same bytes. */
void WriteJson(const RunReport& report, std::ostream& out);

}  // namespace touchstone
