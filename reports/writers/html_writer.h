#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Writes `report` as one self-contained page that opens by a double click: nothing is
 loaded, scripts only filter. Per oracle a summary; per scenario a drawing, the certified
 truth, every answer side by side, and every finding with its proof. Same report, same
 bytes. */
void WriteHtml(const RunReport& report, std::ostream& out);

}  // namespace touchstone
