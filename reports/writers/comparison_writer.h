#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "reports/baseline/baseline.h"
#include "reports/writers/read_report_data.h"

namespace touchstone {

/** Two runs, and what changed from one to the other. */
struct Comparison {
  std::string before;  ///< Name of the earlier run, as the user gave it.
  std::string after;   ///< Name of the later run.
  std::span<const Change> changes;
};

/** Writes a comparison for a terminal: the counts, and at most 20 changes of each kind.
 */
void WriteComparison(const Comparison& comparison, std::ostream& out);

/** Writes a comparison as JSON, the `Comparison` of docs/report_data.md with
 `"format": "touchstone comparison", "version": 1`. */
void WriteComparisonJson(const Comparison& comparison, std::ostream& out);

/** Writes a comparison as JUnit XML: a test case for each change; the worse ones fail. */
void WriteComparisonJUnit(const Comparison& comparison, std::ostream& out);

/** Returns the data of the later run with the comparison in its key `compare`, deflated.
 */
std::string WithComparison(const ReadReportData& data, const Comparison& comparison);

}  // namespace touchstone
