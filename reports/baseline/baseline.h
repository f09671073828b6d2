#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "reports/finding/ledger.h"
#include "reports/run_report.h"
#include "scenarios/diagnostic.h"

namespace touchstone {

/** The findings of an earlier run. */
struct Baseline {
  /** The worst value and the worst verdict of a cell; NaN is worse than any number. */
  struct Measured {
    double value = 0;
    Verdict verdict = Verdict::kPass;
  };
  std::map<LedgerCell, Measured> cells;
};

/** A baseline, or the errors of its file. */
struct BaselineResult {
  std::optional<Baseline> baseline;  ///< Present if and only if there are no diagnostics.
  std::vector<Diagnostic> diagnostics;
};

/** Reads the findings of a report that WriteJson() wrote, `report.json` of `touchstone
 run
 --out`. `file` is the name used in diagnostics. */
BaselineResult ReadBaseline(std::string_view text, const std::filesystem::path& file);

/** Reads a baseline from a file. */
BaselineResult ReadBaselineFile(const std::filesystem::path& file);

/** The least growth of a value that makes it worse. Drake guards its table of accuracies
 by a factor of 12, engines are held to what they did yesterday. [-] */
inline constexpr double kWorse = 2;

/** Adds a regression to `report` for each cell that is worse than in the baseline:

 - its verdict is, by SeverityOf();
 - or its value is more than kWorse times the larger of the earlier one and what rounding
   can cause. For a length that is what an answer or a motion may be off by rounding
 alone, and for each measure it is at least 1 % of its tolerance: below, an error has no
 cause but chance.

 Cells that only one of the two has are not compared. */
void CompareWithBaseline(RunReport& report, const Baseline& baseline);

}  // namespace touchstone
