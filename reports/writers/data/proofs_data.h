#pragma once

#include <span>

#include "reports/finding/finding.h"
#include "reports/writers/data/json_values.h"
#include "reports/writers/data/texts.h"

namespace touchstone {

/** Returns the numbers of all proofs that have any, `Proofs` of docs/report_data.md.
 Numbers round trip. */
DataJson ProofsData(std::span<const Finding> findings, Texts& texts);

/** Returns the errors at smaller steps, `Studies` of docs/report_data.md, to three
 digits. */
DataJson StudiesData(std::span<const Finding> findings);

/** Returns the names of kinds and of claims that ProofsData() refers to by index. */
DataJson ProofNames();

}  // namespace touchstone
