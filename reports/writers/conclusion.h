#pragma once

#include <span>
#include <string>

#include "reports/run_report.h"
#include "reports/writers/outcome.h"

namespace touchstone {

/** Returns what was asked, and how many oracles support any of it: "15 oracles answered 1
 contact question; 4 oracles do not support it." */
std::string AnswersInWords(const RunReport& report);

/** Returns the last line of a run, which agrees with its exit code: "OK: cookbook failed
 in 0 scenarios, …". */
std::string ConclusionOf(const RunReport& report, std::span<const Outcome> outcomes,
                         const FailureRule& rule);

}  // namespace touchstone
