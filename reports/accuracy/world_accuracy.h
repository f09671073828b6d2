#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/run_report.h"

namespace touchstone {

/** The first line of the table of worlds. */
inline constexpr std::string_view kWorldAccuracyHeading = "## Worlds";

/** Returns the published accuracy of motions. Each row is a world and a measure by which
 a law compared the motion with the truth. Its cells are the worst errors of the oracles
 of `report` that simulate, in the unit of the measure, see PublishedCell().

 Before the rows it states, for each oracle, in how many of them its error is the least,
 and lists the rows in which another oracle has a smaller error than the first. Errors
 that differ by less than kAlike of the tolerance count as equal. A motion that passes
 because it follows another legal model (Cause::kModel) has no error. */
std::string WorldAccuracyTable(const RunReport& report);

/** Compares the published table `text` with the errors measured in `report` and returns
 the faults, one sentence each; see CheckAccuracy(). Worlds and oracles that `report` does
 not contain are not checked. */
std::vector<std::string> CheckWorldAccuracy(const RunReport& report,
                                            std::string_view text);

/** The fraction of the least tolerance of a row below which two errors count as equal:
 most of such a difference is rounding. [-] */
inline constexpr double kAlike = 0.01;

}  // namespace touchstone
