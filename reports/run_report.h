#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"
#include "reports/finding/ledger.h"
#include "reports/worlds/study/world_result.h"
#include "reports/worlds/study/world_seconds.h"

namespace touchstone {

/** A finding that is worse than in an earlier run. */
struct Regression {
  std::string oracle;
  std::string what;  ///< The finding, and what it was and is.
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
  /** The time that contact queries took by the clock on the wall, by kind of question:
   "truth", "itself" and the names of variants. Those of
   single answers and worlds are with them. No judgement depends on it. [s] */
  SecondsByName seconds_of_contacts;
  Ledger ledger;
  std::vector<LedgerUse> ledger_use;  ///< Indexed by entry of the ledger.
  /** Faults of the scenario files and the ledger that fail the run: an expectation that
   the truth contradicts; an indictment that is not reproduced; an entry that has expired,
   has improved or matches nothing. One sentence each. It starts with the place in the
   file, or with the id of a scenario that has no file, and says what to do. */
  std::vector<std::string> faults;
  /** Findings that are worse than in a baseline, see CompareWithBaseline(). Fails the run
   as the failures of its oracle do. */
  std::vector<Regression> regressions;
};

/** Returns the time that oracle and judge took for question i: for a contact query that
 of the answer alone. [s] */
double SecondsOf(const RunReport& report, std::size_t oracle, std::size_t i);

/** Returns the number of questions of either kind. */
std::size_t QuestionCount(const RunReport& report);

/** Returns the id of question i: the contact queries first, then the worlds. */
const std::string& IdOf(const RunReport& report, std::size_t i);
/** Returns the title of question i. */
const std::string& TitleOf(const RunReport& report, std::size_t i);

/** Returns whether an oracle answers questions of the kind of question i at all. */
bool Answers(const RunReport& report, std::size_t oracle, std::size_t i);

/** Whose failures count for the exit code. Faults of files always do. */
enum class FailOn {
  kSubject,   ///< The subject's.
  kFaults,    ///< Also those of references that are graver than rounding.
  kAnything,  ///< Also those of references that are rounding.
};

/** The failures that count for the exit code. */
struct FailureRule {
  FailOn whose = FailOn::kFaults;
  /** Failures that are not graver do not count. */
  Grade above = Grade::kNone;
};

/** Returns whether `finding` of `report` is a failure that counts. */
bool CountsAsFailure(const Finding& finding, const RunReport& report,
                     const FailureRule& rule);

/** Returns how many of the faults of files are entries or bounds of the ledger that hide
 less than they allow: they say "improved", and nothing is wrong but the ledger. */
std::size_t ImprovedCount(const RunReport& report);

/** Returns whether any answer of the subject was verified, see IsVerified(). */
bool IsSubjectExamined(const RunReport& report);

/** Returns the exit code of a run. It is 1 if the subject fails or got worse than in a
 baseline; otherwise 2 if none of its answers was verified, whatever the references do. It
 is otherwise 1 for a fault of the files, and for a reference that fails where that
 counts; otherwise 0. */
int ExitCode(const RunReport& report, const FailureRule& rule);

}  // namespace touchstone
