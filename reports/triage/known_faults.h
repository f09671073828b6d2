#pragma once

#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/ledger.h"

namespace touchstone {

/** Returns the faults that `ledger` knows of this version of the oracle, with the
 verdict, the measure and a cause of `finding`, each as a sentence with its upstream link.
 The finding may be one of them, or another fault that looks alike. Empty: it is new. */
std::vector<std::string> KnownFaultsLike(const Finding& finding, const OracleInfo& oracle,
                                         const Ledger& ledger);

}  // namespace touchstone
