#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"
#include "reports/contacts/judge_variant.h"
#include "reports/contacts/tolerance_reasons.h"
#include "reports/finding/ledger.h"
#include "reports/referee/contact_truth.h"
#include "reports/run_report.h"
#include "reports/threads/stop.h"
#include "reports/worlds/study/run_worlds.h"
#include "scenarios/scenario.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The truths of NeighboursOf() each contact query, in the order of their ids, by unit
 roundoff; empty where none was needed. */
using TruthsOfNeighbours = std::vector<std::map<double, std::vector<ContactTruth>>>;

/** The variants of each contact query, in the order of their ids; empty where none was
 needed. */
using VariantsOfAll = std::vector<std::vector<Variant>>;

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
  /** Keeps the truths of questions near those of the run, for runs of other oracles with
   the same contact queries; may be null. */
  TruthsOfNeighbours* truths_of_neighbours = nullptr;
  /** Keeps the variants of the contact queries, for runs of other oracles with the same
   queries; may be null. */
  VariantsOfAll* variants = nullptr;
  /** The most answers of the subject to contact queries whose causes of failure are
   sought, among those that DecisiveOf() gives the same verdict, measure and grade: those
   of the largest ShareOf() and, of equal ones, to the first queries by id. All other
   failures are kNotExamined, and so are those of references to other queries. Empty: all
   are examined. */
  std::optional<std::size_t> examined_per_kind;
  /** The contact findings that carry the reason of their tolerance. */
  Reasons reasons = Reasons::kOfAll;
  Stop stop;  ///< The report is then not whole.
  /** Finds and keeps judged worlds; the rest is not used. */
  WorldsOptions worlds;
  /** Returns whether any build has an oracle of that name, see ApplyLedger(). */
  std::function<bool(std::string_view)> is_oracle;
  /** Called with the numbers of question-oracle pairs, and with the part of the work that
   is done, in [0, 1]: a world takes as long as thousands of contact queries. From one
   thread at a time; may be empty. */
  std::function<void(std::size_t done, std::size_t total, double part)> on_progress;
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
