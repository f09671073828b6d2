#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
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
    double floor = 0;  ///< The value that rounding alone may cause, see FloorOf().
  };
  std::map<LedgerCell, Measured> cells;

  /** Adds a finding of `cell`, or widens what the cell has to hold it. */
  void Add(const LedgerCell& cell, const Measured& measured);
};

/** Returns the findings of one oracle of a run, under the name `as`, so that two oracles
 of one run, such as two versions of an engine, can be compared like two runs. */
Baseline FindingsOf(const Baseline& run, std::string_view oracle, std::string_view as);

/** A baseline, or the errors of its file. */
struct BaselineResult {
  std::optional<Baseline> baseline;  ///< Present if and only if there are no diagnostics.
  std::vector<Diagnostic> diagnostics;
};

/** Reads the findings of a report that WriteJson() wrote, `report.jsonl` of `touchstone
 run --out`. `file` is the name used in diagnostics. */
BaselineResult ReadBaseline(std::string_view text, const std::filesystem::path& file);

/** Reads a baseline from a file. */
BaselineResult ReadBaselineFile(const std::filesystem::path& file);

/** Returns the verdict of that name; empty if there is none. */
std::optional<Verdict> VerdictNamed(const std::string& name);

/** The least growth of a value that makes it worse. Drake guards its table of accuracies
 by a factor of 12, engines are held to what they did yesterday. [-] */
inline constexpr double kWorseFactor = 2;

/** Returns the length by which rounding alone may change the answer of an oracle to a
 question. For a motion that is 64 roundings in each step, as the laws grant. [m] */
double RoundingLength(const RunReport& report, std::size_t question, std::size_t oracle);

/** Returns the value of a measure that rounding alone may cause: for a length at least
 `rounding` [m], for each measure at least 1 % of its tolerance. Below, an error has no
 cause but chance. */
double FloorOf(MeasureKind measure, double tolerance, double rounding);

/** Adds a regression to `report` for each finding that is worse than its cell in the
 baseline:

 - its verdict is, by SeverityOf();
 - or its value is more than kWorseFactor times the larger of the earlier one and its
 floor.

 Cells that only one of the two has are not compared. */
void CompareWithBaseline(RunReport& report, const Baseline& baseline);

/** The fate of a cell from one run to the next. */
enum class ChangeKind {
  kWorse,  ///< Worse by the rule of CompareWithBaseline().
  /** It passed in the earlier run; the later one has no such cell, or neither a pass nor
   a fault in it: it is undecidable or unsupported. */
  kNotJudged,
  kNew,     ///< Only the later run has the cell, and it is a fault there.
  kGone,    ///< Only the earlier run has it, and it was a fault there.
  kBetter,  ///< The earlier run is worse than the later one.
};

/** Returns "worse", "no longer judged", "new", "gone" or "better". */
std::string_view NameOf(ChangeKind kind);

/** Returns whether a change fails the later run: it is worse, or no longer judged. */
bool IsWorse(ChangeKind kind);

/** One cell that differs between two runs. */
struct Change {
  ChangeKind kind = ChangeKind::kWorse;
  LedgerCell cell;
  std::optional<Baseline::Measured> before;  ///< Empty if it is new.
  std::optional<Baseline::Measured> after;   ///< Empty if the later run lacks it.
  std::string what;  ///< "was pass, is fail", "was 1e-9, is 2e-3 m".
};

/** Returns all changes: the worse ones first, then in the order of ChangeKind, each in
 the order of cells. A fault is proved wrong, differing, known, invalid, or without an
 answer. */
std::vector<Change> Compare(const Baseline& before, const Baseline& after);

}  // namespace touchstone
