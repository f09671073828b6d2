#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/run.h"

namespace touchstone {

/** The line that the table of worlds begins with. */
inline constexpr std::string_view kWorldAccuracyHeading = "## Worlds";

/** Returns what is published of motion: for each world, and each measure by which a law
 held it to the truth, the worst error of every oracle of `report` that simulates, in the
 unit of the measure, as PublishedCell(); before it, in how many of these rows the error
 of each oracle is the least, and in which another's is less than that of the first.
 Errors that differ by less than kAlike of what is allowed are alike; what follows another
 legal model (Cause::kModel, and passes) is no error. */
std::string WorldAccuracyTable(const RunReport& report);

/** Returns what is wrong with the published table `text`, one sentence each; see
 CheckAccuracy(). Worlds and oracles that the report does not have are not checked. */
std::vector<std::string> CheckWorldAccuracy(const RunReport& report,
                                            std::string_view text);

/** The share of the least tolerance of a row below which two errors are alike: most of
 such a difference is rounding. [-] */
inline constexpr double kAlike = 0.01;

}  // namespace touchstone
