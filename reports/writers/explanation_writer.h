#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** How much of a report is explained. */
struct ExplanationStyle {
  /** Every contact point and every number of every oracle; without it, of equal answers
   one, of a wrong one the simplest proof, and of motions but the subject's what is beyond
   its tolerance. */
  bool everything = false;
};

/** Writes every scenario of `report` for a person: what is asked, the certified truth,
 who is right and who wrong, every oracle's answer, and the proof of every wrong one with
 its cause and what the ledger says of it. Of worlds, the numbers of the motions beside
 what their laws allow. */
void WriteExplanation(const RunReport& report, const ExplanationStyle& style,
                      std::ostream& out);

/** Writes a line for every scenario of `report`: what is true, the verdict on the
 subject, how many are right, and who is wrong. */
void WriteExplanationTable(const RunReport& report, std::ostream& out);

}  // namespace touchstone
