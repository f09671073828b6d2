#pragma once

#include <functional>
#include <map>
#include <string_view>

#include "reports/run.h"

namespace touchstone {

/** Applies the ledger of `report` to its findings: makes `known` those that an entry
 excuses, fills `ledger_use`, and adds a fault for every entry that is exceeded, has
 expired by the ISO date `today`, or is no longer needed. Where `partial`, only for what
 was put to the test: the scenarios left out may need it.

 Otherwise an entry about nothing is a fault as well: one that concerns no answer of its
 oracle, or an oracle of which `is_oracle` says that no build has it. Empty: every name
 may be one's. Entries for oracles that took no part are let be.

 An entry is void for another version of the library than its own, and says nothing of the
 ledger's strangers. The unit of values and bounds is SceneSize() for lengths of contact
 queries, 1 for all else, see ValueForLedger(); verdicts without a value (crashed, timed
 out, invalid) have no bound to exceed. */
void ApplyLedger(RunReport& report, std::string_view today, bool partial,
                 const std::function<bool(std::string_view)>& is_oracle = {});

/** A bound of which the worst hidden value is below this share is too wide: a
 result that got an order of magnitude better must be written down, or a later regression
 goes unseen. Source: Drake, characterization_utilities.h, which guards its table by the
 same factor. */
inline constexpr double kImproved = 1.0 / 12;

/** What ledger values of one scenario are measured by. */
struct LedgerScale {
  /** What lengths are relative to: SceneSize() of a contact query, 1 m of a world. [m] */
  double size = 1;
  double from_touching = 0;  ///< The most that |separation| may be. [m]
};

/** Returns the scale of every scenario of `report`, by id. */
std::map<std::string_view, LedgerScale> LedgerScalesOf(const RunReport& report);

/** Returns the value of a finding in the unit of ledger bounds. That of `touching`, which
 is 0 or 1, is how far the shapes are from touching: who misses a hairline contact is not
 excused for missing a deep one. */
double ValueForLedger(const Finding& finding, const LedgerScale& scale);

}  // namespace touchstone
