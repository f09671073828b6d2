#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string_view>

#include "reports/run_report.h"

namespace touchstone {

/** Applies the ledger of `report` to its findings. A finding becomes `known` if an entry
 covers it and it keeps within the bound of its cell; a cell without a bound is not
 excused. The last entry that covers a finding hides it, so that exceptions follow rules.
 A finding beyond its bound stays a failure, and its proof says by how much. Fills
 `ledger_use`.

 An entry that has expired by the ISO date `today`, or is no longer needed, adds a fault.
 So do bounds that are no longer needed: nothing was found in their cell, or nothing above
 kImproved of the bound. In a `partial` run only expired entries that were put to the test
 add one: the scenarios left out may need the others, and an oracle left out may have
 settled a vote.

 An entry whose oracle no build has, says `is_oracle`, adds a fault in any run; an empty
 `is_oracle` accepts every name. Entries for oracles that took no part are otherwise
 ignored. A complete run also faults an entry that concerns no answer of its oracle.

 An entry is void for any version of the library but its own, see LedgerUse::voided. It
 does not apply to the ledger's scenarios `outside_catalogue`, nor to worlds of an oracle
 whose setup is not the default one. Values and bounds are in
 units of SceneSize() for lengths of contact queries and in units of 1 otherwise, see
 ValueForLedger(). Verdicts without a value (crashed, timed out, invalid) have no bound to
 exceed: the bound names the verdict. An intermittent entry excuses them without one. */
void ApplyLedger(RunReport& report, std::string_view today, bool partial,
                 const std::function<bool(std::string_view)>& is_oracle = {});

/** Applies the ledger of `report` again, after a change of its bounds. Adds no faults. */
void ApplyAgain(RunReport& report);

/** The fraction of a bound below which its worst hidden value makes it too wide. A result
 that improved by an order of magnitude must be written down, or a later regression goes
 unseen. Source: Drake, characterization_utilities.h, which guards its table by the same
 factor. [-] */
inline constexpr double kImproved = 1.0 / 12;

/** The scale of the ledger values of one scenario. */
struct LedgerScale {
  /** The length that lengths are relative to: SceneSize() of a contact query, 1 m for a
   world. [m] */
  double size = 1;
  double from_touching = 0;  ///< Upper bound on |separation|. [m]
  bool is_relative = false;  ///< Whether there is a scene that lengths are relative to.
};

/** Returns the scale of every scenario of `report`, keyed by id. */
std::map<std::string_view, LedgerScale> LedgerScalesOf(const RunReport& report);

/** Returns the value of a finding in the unit of ledger bounds. The value of `touching`,
 which is 0 or 1, becomes the distance of the shapes from touching: an excuse for a missed
 hairline contact does not excuse missing a deep one. */
double ValueForLedger(const Finding& finding, const LedgerScale& scale);

/** Returns whether a bound is a length, relative to the scene, of at least `share`. */
bool IsLengthOf(double share, MeasureKind measure, double bound,
                const LedgerScale& scale);

/** Returns the cell of a finding. */
LedgerCell CellOf(const Finding& finding);

/** Returns whether an entry is about a cell: its oracle, one of its scenarios and one of
 its measures. */
bool Concerns(const LedgerEntry& entry, const LedgerCell& cell);

/** Returns the entry, by index, that covers a finding of `verdict` in `cell`: the last
 that concerns it, is for that verdict and is not void. */
std::optional<std::size_t> EntryFor(const RunReport& report, const LedgerCell& cell,
                                    Verdict verdict);

/** Returns whether a failure keeps within a bound.
 @param value Its ValueForLedger(). A NaN keeps within none. */
bool IsWithin(const LedgerBound& bound, Verdict verdict, double value);

/** Returns whether a bound is no longer needed by a finding of its cell: the finding has
 another verdict than the bound, or its value is 0 or below kImproved of the bound. A
 finding that passes just below its tolerance still needs it: on another machine it may
 fail.
 @param verdict The verdict of the finding before the ledger was applied. */
bool IsImproved(const LedgerBound& bound, const Finding& finding, Verdict verdict,
                double value);

}  // namespace touchstone
