#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/finding/ledger.h"
#include "reports/run.h"
#include "scenarios/diagnostic.h"

namespace touchstone {

/** A ledger, or everything that is wrong with its file. */
struct LedgerResult {
  std::optional<Ledger> ledger;  ///< Present exactly where there are no diagnostics.
  std::vector<Diagnostic>
      diagnostics;  ///< Every error of the file, in the order of lines.
};

/** Reads a ledger from TOML, one [[entry]] a known discrepancy, with the keys of
 LedgerEntry; `expires` is a TOML date. What is accepted is the table `bounds`, by
 measure, or where the verdict has no value the list `measures`. `file` is what
 diagnostics call it. */
LedgerResult ReadLedger(std::string_view text, const std::filesystem::path& file);

/** Reads the ledger of a file. */
LedgerResult ReadLedgerFile(const std::filesystem::path& file);

/** Returns the text of `entry` as it stands in a ledger file, with the lines of `comment`
 before it. */
std::string WriteLedgerEntry(const LedgerEntry& entry, std::string_view comment);

/** Returns ledger entries for every failure of `report` that no entry excuses, as text to
 be completed by a person: `reason` is left empty, and ReadLedger() refuses an empty
 reason.

 One entry for the failures of one oracle and verdict that share measures and cause, in a
 whole folder of scenarios where all that it answers there fail so, else in one scenario.
 Bounds are kProposedBound times the worst value, rounded up to two digits.
 @param expires ISO date that the entries get; empty: left to the person. */
std::string ProposeLedger(const RunReport& report, std::string_view expires = "");

/** Above the worst value seen by enough for another machine's rounding, below the factor
 of twelve at which an entry is called improved. [-] */
inline constexpr double kProposedBound = 1.5;

/** Returns whether `measure` is 0 or 1, or a share: no bound above 1 is one. */
bool IsShare(MeasureKind measure);

/** Returns `value` rounded up to two decimal digits, 0 for anything not positive. */
double RoundedUp(double value);

}  // namespace touchstone
