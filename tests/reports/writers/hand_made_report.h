#pragma once

#include "reports/run_report.h"

namespace touchstone {

/** Returns a report with one of everything that a writer has to show. It has two oracles
 ("mine", the subject, and "theirs/float") and three scenarios in two groups. Their
 outcomes are a pass, a proved failure with two measures, a known discrepancy, an
 undecidable, an unsupported and a NaN. The ledger has two entries, one without
 candidates. There is one fault, and text that needs escaping. */
RunReport HandMadeReport();

}  // namespace touchstone
