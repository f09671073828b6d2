#pragma once

#include <utility>

#include "oracles/oracle.h"
#include "reports/contacts/checks/judged_answer.h"
#include "tests/reports/specimens.h"

namespace touchstone {

/** Returns what `check` finds in an answer of the oracle "mine" to a specimen.
 @pre The check applies, and does not depend on what an earlier one has found. */
inline Finding FoundBy(void (*check)(JudgedAnswer&), const Specimen& specimen,
                       const ContactAnswer& answer) {
  Scenario scenario;
  scenario.contact = specimen.query;
  OracleInfo mine;
  mine.name = "mine";
  JudgedAnswer judged(scenario, specimen.truth, mine, answer, Reasons::kOfAll);
  check(judged);
  return std::move(judged).Findings().at(0);
}

}  // namespace touchstone
