#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/ledger.h"
#include "reports/referee/contact_truth.h"
#include "reports/run_report.h"
#include "scenarios/scenario.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The options of a run. */
struct RunOptions {
  int jobs =
      0;  ///< Number of threads; 0: one per core. The result does not depend on it.
  /** ISO date, e.g. "2025-03-31", against which ledger entries expire; empty: none
   expires. It is passed in so that judging never reads the clock. */
  std::string today;
  /** Whether the scenarios are only a part of the catalogue. A ledger entry that hides
   nothing may then still be needed by the others, and is not called improved. */
  bool partial = false;
  /** The truths of the contact queries, in the order in which those are passed, if they
   are known already; empty: they are computed. */
  std::span<const ContactTruth> truths;
  /** Returns whether any build has an oracle of that name, see ApplyLedger(). */
  std::function<bool(std::string_view)> is_oracle;
  /** Called with the numbers of question-oracle pairs (done, total), from one thread at a
   time; may be empty. */
  std::function<void(std::size_t, std::size_t)> on_progress;
};

/** The questions of a run. */
struct Questions {
  std::vector<Scenario> contacts;
  std::vector<WorldScenario> worlds;
};

/** Asks every oracle every question and judges the answers. `oracles[0]` is the subject.
 The result is deterministic and independent of the number of jobs. */
RunReport Run(const Questions& questions, std::span<const Oracle* const> oracles,
              const Ledger& ledger, const RunOptions& options);

/** The same for contact queries only. */
RunReport Run(std::span<const Scenario> scenarios, std::span<const Oracle* const> oracles,
              const Ledger& ledger, const RunOptions& options);

}  // namespace touchstone
