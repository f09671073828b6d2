#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Writes `report` as one self-contained page that opens by a double click. It loads
 nothing, and its script only filters. It has a summary per oracle; per scenario it has a
 drawing, the certified truth, all answers side by side, and every finding with its proof.
 The same report gives the same bytes. */
void WriteHtml(const RunReport& report, std::ostream& out);

}  // namespace touchstone
