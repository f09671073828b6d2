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

/** One scenario with everything that was said about it. */
struct ScenarioResult {
  Scenario scenario;
  ContactTruth truth;
  std::vector<ContactAnswer> answers;  ///< In the order of RunReport::oracles.
};

/** The outcome of a run: data for the writers, which add nothing to it. */
struct RunReport {
  std::string subject;                    ///< Name of the oracle under examination.
  std::vector<OracleInfo> oracles;        ///< The subject first, then the references.
  std::vector<ScenarioResult> scenarios;  ///< Contact queries, in the order of their ids.
  std::vector<WorldResult> worlds;        ///< In the order of their ids.
  /** First of the contact queries, then of the worlds; each sorted by scenario, then
   oracle (as above), then measure. One finding per measure that applies; a question that
   an oracle does not support gives one kUnsupported finding. An oracle has no finding on
   questions of a kind that it does not answer at all. */
  std::vector<Finding> findings;
  Ledger ledger;
  std::vector<LedgerUse> ledger_use;  ///< Per entry of the ledger.
  /** Faults of the scenario files and the ledger that fail the run: an expectation that
   the truth contradicts, an indictment not found again, an entry exceeded, expired or
   improved. One sentence each, which starts with the place in the file (with the id of a
   scenario that has none), and says what to do. */
  std::vector<std::string> faults;
};

/** How to run. */
struct RunOptions {
  int jobs = 0;  ///< Threads; 0: one per core. The result does not depend on it.
  /** ISO date, e.g. "2025-03-31", against which ledger entries expire; empty: none does.
   Passed in, so that no judge reads the clock. */
  std::string today;
  /** The scenarios are not the whole catalogue: a ledger entry that hides nothing may
   still be needed by those left out, and is not called improved. */
  bool partial = false;
  /** Whether any build has an oracle of that name, see ApplyLedger(). */
  std::function<bool(std::string_view)> is_oracle;
  /** Called with (done, total) question-oracle pairs, from one thread at a time; may be
   * empty. */
  std::function<void(std::size_t, std::size_t)> on_progress;
};

/** What a run asks. */
struct Questions {
  std::vector<Scenario> contacts;
  std::vector<WorldScenario> worlds;
};

/** Asks every oracle every question and judges the answers. `oracles[0]` is the subject.
 Deterministic whatever the number of jobs. */
RunReport Run(const Questions& questions, std::span<const Oracle* const> oracles,
              const Ledger& ledger, const RunOptions& options);

/** As above, of contact queries only. */
RunReport Run(std::span<const Scenario> scenarios, std::span<const Oracle* const> oracles,
              const Ledger& ledger, const RunOptions& options);

/** Returns the number of questions of either kind. */
std::size_t QuestionCount(const RunReport& report);

/** Returns the id of question i: the contact queries first, then the worlds. */
const std::string& IdOf(const RunReport& report, std::size_t i);
/** Returns its title. */
const std::string& TitleOf(const RunReport& report, std::size_t i);

/** Returns whether an oracle answers questions of the kind of question i at all. */
bool Answers(const RunReport& report, std::size_t oracle, std::size_t i);

/** Which failures count. */
enum class FailOn {
  kAnything,  ///< A reference proved wrong outside the ledger fails the run too.
  kSubject,   ///< Only the subject's failures and the faults of files count.
};

/** Returns whether anything that the subject answered was held against something. */
bool IsSubjectExamined(const RunReport& report);

/** Returns the exit code of a run: 1 where the subject fails; else 2 where nothing of it
 was verified, whatever the references do; else 1 for a fault of the files, and for a
 reference that fails where that counts; else 0. */
int ExitCode(const RunReport& report, FailOn fail_on);

}  // namespace touchstone
