#pragma once

#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "oracles/oracle.h"
#include "reports/shrink/question.h"
#include "reports/triage/symptom.h"
#include "reports/writers/read_report_data.h"

namespace touchstone {

/** An answer of a run that failed, outside the ledger. */
struct FailedAnswer {
  Question question;
  std::string oracle;
  std::set<std::pair<MeasureKind, std::string>> cells;  ///< Measures and laws it failed.
};

/** The questions of a run, and the answers to ask for again: a report does not say how an
 answer ended. */
struct RunQuestions {
  std::vector<Asked> asked;
  std::vector<FailedAnswer> failed;
};

/** The file of a question in the data of a report that cannot be read. */
struct UnreadableQuestion : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/** Returns the questions that a run put to `oracles`, by name. Throws UnreadableQuestion.
 */
RunQuestions QuestionsOf(const ReadReportData& run, const std::set<std::string>& oracles);

/** Asks for an answer again. Returns a tally of one question, with its faults in the
 cells that failed before: the ledger may know the others. */
OracleTally AskAgain(const FailedAnswer& answer, const Oracle& oracle);

/** Returns the failures of a run.
 @param again AskAgain() each of `run.failed`; empty where there was no time. */
Failures FailuresOf(const RunQuestions& run,
                    std::span<const std::optional<OracleTally>> again);

}  // namespace touchstone
