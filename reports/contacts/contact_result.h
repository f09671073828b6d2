#pragma once

#include <vector>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** One scenario, its truth and the answers to it. */
struct ScenarioResult {
  Scenario scenario;
  ContactTruth truth;
  std::vector<ContactAnswer> answers;  ///< In the order of RunReport::oracles.
};

}  // namespace touchstone
