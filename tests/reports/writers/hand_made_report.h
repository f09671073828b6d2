#pragma once

#include "reports/run_report.h"

namespace touchstone {

/** Returns a report with one of everything that a writer has to show: two oracles
 ("mine", the subject, and "theirs/float"), three scenarios in two groups, a pass, a
 proved failure with two measures, a known discrepancy, an undecidable, an unsupported and
 a NaN; a ledger of two entries, one not put to the test; one fault; and text that needs
 escaping. */
RunReport HandMadeReport();

}  // namespace touchstone
