#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** How the terminal table looks. */
struct TableStyle {
  bool colours = false;  ///< ANSI colours; only for a terminal.
  bool quiet = false;    ///< The failures that count and the last line only.
  /** Which failures count: the last line says what the exit code does. */
  FailOn fail_on = FailOn::kAnything;
};

/** Writes `report` for a terminal: per group of scenarios and oracle the outcomes and the
 worst measure relative to its tolerance; the sum per oracle; every failure as a sentence
 with its proof; what the ledger hides, and why; the counts of all verdicts. */
void WriteTable(const RunReport& report, const TableStyle& style, std::ostream& out);

}  // namespace touchstone
