#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Writes where the time of a run went: the twenty answers and worlds that took longest,
 and the sums by oracle, by kind of motion, by law and by kind of contact query. */
void WriteTimings(const RunReport& report, std::ostream& out);

}  // namespace touchstone
