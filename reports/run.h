#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/finding/ledger.h"
#include "reports/referee/contact_truth.h"
#include "reports/worlds/study/run_worlds.h"
#include "scenarios/scenario.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** One scenario, its truth and the answers to it. */
struct ScenarioResult {
  Scenario scenario;
  ContactTruth truth;
  std::vector<ContactAnswer> answers;  ///< In the order of RunReport::oracles.
};

/** The outcome of a run: all data that the writers show. */
struct RunReport {
  std::string subject;                    ///< Name of the oracle under examination.
  std::vector<OracleInfo> oracles;        ///< The subject first, then the references.
  std::vector<ScenarioResult> scenarios;  ///< Contact queries, in the order of their ids.
  std::vector<WorldResult> worlds;        ///< In the order of their ids.
  /** The findings: first those of contact queries, then those of worlds, each sorted by
   scenario, then oracle (in the order above), then measure. One finding per measure that
   applies; a question that an oracle does not support has one kUnsupported finding. An
   oracle has no findings on questions of a kind that it does not answer at all. */
  std::vector<Finding> findings;
  Ledger ledger;
  std::vector<LedgerUse> ledger_use;  ///< Indexed by entry of the ledger.
  /** Faults of the scenario files and the ledger that fail the run: an expectation that
   the truth contradicts; an indictment that is not reproduced; an entry that has expired,
   has improved or matches nothing. One sentence each. It starts with the place in the
   file, or with the id of a scenario that has no file, and says what to do. */
  std::vector<std::string> faults;
};

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

/** Returns the number of questions of either kind. */
std::size_t QuestionCount(const RunReport& report);

/** Returns the id of question i: the contact queries first, then the worlds. */
const std::string& IdOf(const RunReport& report, std::size_t i);
/** Returns the title of question i. */
const std::string& TitleOf(const RunReport& report, std::size_t i);

/** Returns whether an oracle answers questions of the kind of question i at all. */
bool Answers(const RunReport& report, std::size_t oracle, std::size_t i);

/** The failures that count for the exit code. */
enum class FailOn {
  kAnything,  ///< A reference proved wrong outside the ledger fails the run too.
  kSubject,   ///< Only the subject's failures and the faults of files count.
};

/** Returns whether any answer of the subject was verified, see IsVerified(). */
bool IsSubjectExamined(const RunReport& report);

/** Returns the exit code of a run. It is 1 if the subject fails; otherwise 2 if none of
 its answers was verified, whatever the references do. It is otherwise 1 for a fault of
 the files, and for a reference that fails where that counts; otherwise 0. */
int ExitCode(const RunReport& report, FailOn fail_on);

}  // namespace touchstone
