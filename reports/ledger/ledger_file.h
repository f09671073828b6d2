#pragma once

#include <filesystem>
#include <optional>
#include <span>
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
 LedgerEntry; `expires` is a TOML date, `scenarios` a glob and `cause` a name, or a list
 of them. `file` is the name used in diagnostics. The ledger has no bounds yet. */
LedgerResult ReadLedger(std::string_view text, const std::filesystem::path& file);

/** Reads a ledger from a file, and its bounds from the file next to it, BoundsFileOf().
 */
LedgerResult ReadLedgerFile(const std::filesystem::path& file);

/** Returns the line of a ledger file that states causes: a name, or a list of names. */
std::string CauseLine(std::span<const Cause> causes);

/** Returns the text of `entry` for a ledger file, preceded by the lines of `comment`. */
std::string WriteLedgerEntry(const LedgerEntry& entry, std::string_view comment);

/** Returns, as text, ledger entries for every failure of `report` that no entry excuses.
 A person has to complete them: `reason` is left empty, and ReadLedger() refuses an empty
 reason.

 One entry covers the failures of one oracle with the same verdict, cause and measures: in
 a whole folder of scenarios where all scenarios that the oracle answers fail that way,
 otherwise in one scenario. UpdateBounds() bounds them once they are complete.
 @param expires ISO date for the entries; empty leaves it to the person. */
std::string ProposeLedger(const RunReport& report, std::string_view expires = "");

}  // namespace touchstone
