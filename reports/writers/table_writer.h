#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Options of the terminal table. */
struct TableStyle {
  bool colours = false;  ///< ANSI colours; only for a terminal.
  bool quiet = false;    ///< Only the failures that count and the last line.
  /** Failures that count. The last line agrees with the exit code. */
  FailOn fail_on = FailOn::kAnything;
};

/** Writes `report` for a terminal. Per group of scenarios and oracle, it writes the
 outcomes and the worst measure relative to its tolerance. Then follow the sum per oracle,
 every failure as a sentence with its proof, the findings that the ledger hides with their
 reasons, and the counts of all verdicts. */
void WriteTable(const RunReport& report, const TableStyle& style, std::ostream& out);

}  // namespace touchstone
