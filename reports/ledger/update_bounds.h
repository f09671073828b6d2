#pragma once

#include "reports/finding/ledger.h"
#include "reports/run_report.h"

namespace touchstone {

/** Bounds for the findings of a run, and the counts of what changed. */
struct UpdatedBounds {
  LedgerBounds bounds;
  int added = 0;
  int changed = 0;  ///< Bounds that were exceeded or twelve times too wide.
  int removed = 0;
  int uncovered = 0;  ///< Failures that no entry covers. They get no bound.
};

/** Returns the bounds of the ledger of `report` as its findings need them. A failure that
 an entry covers gets a bound of ProposedBound(). A bound that holds and is not improved,
 see IsImproved(), stays as it is: a run on another machine, whose roundings differ,
 changes nothing. So do bounds that the run did not put to the test: those of scenarios
 and oracles left out, of void entries, and of intermittent ones that hid nothing. */
UpdatedBounds UpdateBounds(const RunReport& report);

/** Returns the bound for a failure of a value: kProposedBound times it, rounded up to two
 digits; at most 1 for a share, and the value itself for a count. */
double ProposedBound(MeasureKind measure, double value);

/** The factor between a bound and the worst value seen: large enough for another
 machine's rounding, and below the factor of twelve at which a bound is called improved.
 [-] */
inline constexpr double kProposedBound = 1.5;

/** Returns `value` rounded up to two significant decimal digits, or 0 if it is not
 positive. */
double RoundedUp(double value);

}  // namespace touchstone
