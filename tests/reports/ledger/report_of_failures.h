#pragma once

#include <cstddef>
#include <initializer_list>

#include "reports/run_report.h"

namespace touchstone {

/** Returns the cell of a measure of "ode" in scenario i of ReportOfFailures(). */
LedgerCell CellOfFailure(std::size_t i, MeasureKind measure = MeasureKind::kExcess);

/** Returns a report of failures of "ode" with the given values of `excess`, relative to
 the size of their scenes, one scenario each, and a ledger with one entry for them and the
 same bound for all. A value of 0 passes. */
RunReport ReportOfFailures(std::initializer_list<double> values, double bound);

}  // namespace touchstone
