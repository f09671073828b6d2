#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/finding/ledger.h"
#include "reports/run_report.h"
#include "scenarios/diagnostic.h"

namespace touchstone {

/** A ledger, or all errors of its file. */
struct LedgerResult {
  std::optional<Ledger> ledger;  ///< Present if and only if there are no diagnostics.
  /** All errors of the file, in the order of lines. */
  std::vector<Diagnostic> diagnostics;
};

/** Reads a ledger from TOML: one [[entry]] per known discrepancy, with the keys of
 LedgerEntry; `expires` is a TOML date. The accepted measures are the keys of the table
 `bounds`, or the list `measures` where the verdict has no value. `file` is the name used
 in diagnostics. */
LedgerResult ReadLedger(std::string_view text, const std::filesystem::path& file);

/** Reads a ledger from a file. */
LedgerResult ReadLedgerFile(const std::filesystem::path& file);

/** Returns the text of `entry` for a ledger file, preceded by the lines of `comment`. */
std::string WriteLedgerEntry(const LedgerEntry& entry, std::string_view comment);

/** Returns, as text, ledger entries for every failure of `report` that no entry excuses.
 A person has to complete them: `reason` is left empty, and ReadLedger() refuses an empty
 reason.

 One entry covers the failures of one oracle with the same verdict, cause and measures: in
 a whole folder of scenarios where all scenarios that the oracle answers fail that way,
 otherwise in one scenario. Bounds are kProposedBound times the worst value, rounded up to
 two digits.
 @param expires ISO date for the entries; empty leaves it to the person. */
std::string ProposeLedger(const RunReport& report, std::string_view expires = "");

/** The factor between a proposed bound and the worst value seen: large enough for another
 machine's rounding, and below the factor of twelve at which an entry is called improved.
 [-] */
inline constexpr double kProposedBound = 1.5;

/** Returns whether the values of `measure` are 0 or 1, or fractions, so that a bound
 above 1 would bound nothing. */
bool IsShare(MeasureKind measure);

/** Returns `value` rounded up to two significant decimal digits, or 0 if it is not
 positive. */
double RoundedUp(double value);

}  // namespace touchstone
