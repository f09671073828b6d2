#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/ledger.h"
#include "reports/run.h"

namespace touchstone {

/** The parts of a sweep's file that are asked again for its page. */
struct KeptQuestions {
  std::vector<std::string> subjects;  ///< The oracles that were judged, in order.
  /** Each once and sorted by id. The id of a question of a worst-case search ends with
   the oracle that was searched. */
  Questions questions;
};

/** The greatest number of questions of failures that are asked again, and as many of the
 worst findings. */
struct KeptLimits {
  std::size_t contacts = 0;  ///< For a sweep of contact questions.
  std::size_t worlds = 0;    ///< For a sweep of worlds.
};

/** Reads the questions of failures that a sweep has kept, and makes those of the worst
 findings of each measure, whatever their verdicts. The gravest failure by share of
 each oracle, measure, law and cause comes first, then the second of each and the third,
 so that a frequent fault does not hide the others. The worst findings are those of the
 most tolerances, one for each oracle, measure and law; those of questions from a file
 are left out if that file has changed since. The file is not changed.
 `oracle_named` returns a subject, which a worst-case search is repeated with. Throws
 SweepFileError. */
KeptQuestions ReadKeptQuestions(
    const std::filesystem::path& file, const KeptLimits& limits,
    const std::function<const Oracle&(const std::string&)>& oracle_named);

/** Returns report data `data` with the section `sweep` of docs/report_data.md: the counts
 and distributions of a sweep. Failures and worst findings whose questions are in `data`
 refer to them. A fault is called new if `ledger` has no entry of its oracle and version,
 verdict, measure and cause. The file is not changed. Throws SweepFileError. */
std::string WithSweep(const std::string& data, const std::filesystem::path& file,
                      const Ledger& ledger);

}  // namespace touchstone
