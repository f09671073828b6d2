#pragma once

#include <ostream>

#include "reports/run_report.h"

namespace touchstone {

/** The level of detail of an explanation. */
struct ExplanationStyle {
  /** Print every contact point and every number of every oracle. If false, equal answers
   are printed once, a wrong answer has its simplest proof only, and the motions of the
   references have only the numbers beyond their tolerances. */
  bool everything = false;
};

/** Writes every scenario of `report` for a person: the question, the certified truth, the
 oracles that are right and wrong, every answer, and a proof against every wrong one with
 its cause and the reason of its ledger entry. For worlds, writes the numbers of the
 motions next to the tolerances of their laws. */
void WriteExplanation(const RunReport& report, const ExplanationStyle& style,
                      std::ostream& out);

/** Writes a line for every scenario of `report`: the truth, the verdict on the subject,
 the number of oracles that are right, and the names of those that are wrong. */
void WriteExplanationTable(const RunReport& report, std::ostream& out);

}  // namespace touchstone
