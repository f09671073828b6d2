#pragma once

#include <cstddef>
#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** Options of the terminal table. */
struct TableStyle {
  bool colours = false;   ///< ANSI colours; only for a terminal.
  bool quiet = false;     ///< Only the failures that count and the last line.
  std::size_t width = 0;  ///< Characters of a line of the terminal; 0: wraps nothing.
  /** Failures that count. The last line agrees with the exit code. */
  FailureRule rule = {};
};

/** Writes `report` for a terminal: a row of counts and the worst measure relative to its
 tolerance for each oracle; every failure as a sentence with its proof; the ten gravest
 clusters of faults, known ones included; and the counts of all verdicts. A run of at most
 20 questions also gets the reasons of what was recognised, unverified and unsupported;
 a larger one their numbers, so that it fits a screen. */
void WriteTable(const RunReport& report, const TableStyle& style, std::ostream& out);

}  // namespace touchstone
