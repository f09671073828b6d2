#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scenarios/diagnostic.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** The contact questions of a run, or the first error of its report. */
struct ReportQuestions {
  std::vector<Scenario> scenarios;  ///< In the order of the report.
  std::optional<Diagnostic> error;
};

/** Reads the questions in a `report.jsonl` that `touchstone run --out` wrote, bit for
 bit. The report has neither the tolerances nor the indictments of scenario files. */
ReportQuestions ReadReportQuestions(const std::filesystem::path& file);

}  // namespace touchstone
