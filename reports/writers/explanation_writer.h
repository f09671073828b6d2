#pragma once

#include <ostream>

#include "reports/run.h"

namespace touchstone {

/** Writes each scenario of `report` for a terminal: the question, the certified truth,
 every oracle's answer side by side with its contacts, every finding that is not a pass
 with its proof, and who is proved right and wrong. */
void WriteExplanation(const RunReport& report, std::ostream& out);

/** Writes a line for each scenario of `report`: the certified truth, the verdict on the
 subject, how many oracles are right, and who is proved wrong. */
void WriteExplanationTable(const RunReport& report, std::ostream& out);

}  // namespace touchstone
