#pragma once

#include "reports/finding/finding.h"

namespace touchstone {

/** Returns the rank of a verdict; the larger, the worse: pass, then undecidable, then
 proved wrong or differing, whether the ledger knows it or not, then invalid, crashed or
 timed out, then unsupported. The enumeration has another order. */
int SeverityOf(Verdict verdict);

/** Returns the worse of two verdicts, the first of two equally bad ones. */
Verdict Worse(Verdict a, Verdict b);

}  // namespace touchstone
