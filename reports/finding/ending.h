#pragma once

#include <string>

#include "reports/finding/finding.h"

namespace touchstone {

/** Returns `proof` with its numbers replaced by '#'. Two proofs are of the same kind if
 they differ in their numbers only. The line in "file.cc:12:" stays: it is a place in the
 engine's source. */
std::string KindOfProof(const std::string& proof);

/** Returns how an answer that is missing or invalid ended, its proof without the name of
 the oracle: by a signal, an assertion, an exception, or what is not a number. Empty for
 every other verdict. */
std::string EndingInWords(const Finding& finding);

/** Returns the kind of that, see KindOfProof(). */
std::string EndingOf(const Finding& finding);

}  // namespace touchstone
