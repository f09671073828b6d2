#pragma once

#include <string>
#include <vector>

#include "reports/finding/ledger.h"
#include "reports/run.h"
#include "reports/triage/root.h"

namespace touchstone {

/** Returns the faults that `ledger` knows of the oracles of a root, in their versions,
 with the verdict and the measure of one of its symptoms or of its smallest question, each
 as a sentence with its upstream links: those that show in a question of the catalogue
 that MayShow() the root. The root may be one of them, or another fault that looks alike.
 Empty: it is new.
 @param catalogue The questions that the entries are about. */
std::vector<std::string> KnownFaultsLike(const Root& root, const Ledger& ledger,
                                         const Questions& catalogue);

}  // namespace touchstone
