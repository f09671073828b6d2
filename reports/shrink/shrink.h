#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/run_report.h"
#include "reports/shrink/question.h"

namespace touchstone {

/** The limits of a search for a smaller question. */
struct ShrinkOptions {
  /** The greatest number of smaller questions that are asked. Their shifts are asked in
   addition. */
  std::size_t tries = 5000;
  /** If not empty, the value of the fault stays over this number, and may otherwise
   become smaller; see IsSameFault(). [unit of the measure] */
  std::optional<double> over = std::nullopt;
  /** Limit of the answers that time out: each takes seconds. */
  std::size_t hangs = std::numeric_limits<std::size_t>::max();
  /** Called before each question with the number of those asked; may be empty. */
  std::function<void(std::size_t)> on_try = nullptr;
  /** Returns whether the search ends with what it has; may be empty. */
  std::function<bool()> stop = nullptr;
};

/** The result of Shrink(). */
struct Shrunk {
  Question question;
  Finding finding;             ///< The fault, found on `question`.
  std::size_t tried = 0;       ///< Candidates that the oracle was asked.
  std::size_t accepted = 0;    ///< Those of them that showed the fault and were kept.
  bool is_smallest = false;    ///< No reduction makes it smaller; else it was cut short.
  std::optional<double> over;  ///< Same as ShrinkOptions::over.
  /** Number of ShiftsOf() the question that show the fault, too; empty for a world or a
   hang, or if the search was stopped. */
  std::optional<std::size_t> shifts;
};

/** Puts `question` to `oracle` alone, and judges the answer without a ledger. */
RunReport AskAlone(const Question& question, const Oracle& oracle);

/** Returns a smaller question on which `oracle` has the same fault, IsSameFault():
 `fault` is one of the findings of AskAlone(question, oracle) with a verdict that
 IsFailure().

 The search is greedy. It tries the candidates of one reduction after the other
 (Reductions()). A candidate is kept if it is valid and smaller by SizeOf(), if the oracle
 answers it by the same algorithm, and if it shows the fault. If the fault is no matter of
 chance, it must stay so: a contact candidate shows it in at least half as many of its
 ShiftsOf() as the original does. An exact tie of the original may stay a tie. The search
 ends when no
 candidate is kept, the tries run out, or it is stopped. It is deterministic if the oracle
 is. The answer that a contact file expects and the indictments are removed: they hold for
 the original alone. */
Shrunk Shrink(const Question& question, const Oracle& oracle, const Finding& fault,
              const ShrinkOptions& options = {});

}  // namespace touchstone
