#pragma once

#include <functional>
#include <set>
#include <string>

#include "reports/run_report.h"

namespace touchstone {

/** Facts about the run itself. */
struct RunFacts {
  std::string program;  ///< "touchstone 0.1.0".
  std::string command;  ///< The command that made the run, without its output.
  FailureRule rule = {};
  /** Ids of questions that only their files ask: a command cannot name them by their ids.
   */
  std::set<std::string, std::less<>> own = {};
};

/** Returns the data of a report page in the format of docs/report_data.md, deflated. The
 same report and facts give the same bytes. */
std::string ReportData(const RunReport& report, const RunFacts& facts);

}  // namespace touchstone
