#pragma once

#include <functional>
#include <map>
#include <string_view>

#include "reports/run_report.h"

namespace touchstone {

/** Applies the ledger of `report` to its findings. Findings that an entry excuses become
 `known`, and `ledger_use` is filled. A finding beyond the bound of its entry stays a
 failure, and its proof says by how much. An entry that has expired by the ISO date
 `today`, or is no longer needed, adds a fault. In a `partial` run only expired entries
 that were put to the test add one: the scenarios left out may need the others.

 A complete run also faults an entry that matches nothing: it concerns no answer of its
 oracle, or `is_oracle` says that no build has an oracle of its name. An empty `is_oracle`
 accepts every name. Entries for oracles that took no part are otherwise ignored.

 An entry is void for any version of the library but its own. It does not apply to the
 ledger's scenarios `outside_catalogue`, nor to worlds of an oracle whose setup is not the
 default one. Values and bounds are in units of SceneSize() for
 lengths of contact queries and in units of 1 otherwise, see ValueForLedger(). Verdicts
 without a value (crashed, timed out, invalid) have no bound to exceed. */
void ApplyLedger(RunReport& report, std::string_view today, bool partial,
                 const std::function<bool(std::string_view)>& is_oracle = {});

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
};

/** Returns the scale of every scenario of `report`, keyed by id. */
std::map<std::string_view, LedgerScale> LedgerScalesOf(const RunReport& report);

/** Returns the value of a finding in the unit of ledger bounds. The value of `touching`,
 which is 0 or 1, becomes the distance of the shapes from touching: an excuse for a missed
 hairline contact does not excuse missing a deep one. */
double ValueForLedger(const Finding& finding, const LedgerScale& scale);

}  // namespace touchstone
