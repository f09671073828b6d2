#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/run_report.h"
#include "scenarios/generators/generate.h"

namespace touchstone {

/** A seeded series of generated questions, the same on every machine. */
struct QuestionSeries {
  Family family = Family::kRandom;
  ShapeKind A = ShapeKind::kBox;
  ShapeKind B = ShapeKind::kBox;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< Index of the first question.
  std::uint64_t count = 1000;
};

/** Returns question `index` of the series as a scenario with an id such as
 "sweep/random/box_box/seed_1/0...42". */
Scenario ScenarioAt(const QuestionSeries& series, std::uint64_t index);

/** Returns the command line that repeats question `index`. */
std::string ReplayOf(const QuestionSeries& series, std::uint64_t index);

/** The worst value of a measure relative to its tolerance. */
struct WorstMeasure {
  double relative = 0;      ///< Value as a multiple of the tolerance. [-]
  double value = 0;         ///< Value in the measure's unit.
  std::uint64_t index = 0;  ///< Index of the question.
};

/** A question that the subject failed, with the report of it. */
struct FailedQuestion {
  std::uint64_t index;
  RunReport report;  ///< Report of this one question.
};

/** The result of a sweep. A sweep in which no bodies touched has verified nothing. */
struct SweepResult {
  std::uint64_t asked = 0;        ///< Number of questions.
  std::uint64_t touching = 0;     ///< Questions certified as touching.
  std::uint64_t undecided = 0;    ///< Questions touching to within the input's rounding.
  std::uint64_t unsupported = 0;  ///< Questions that the subject does not support.
  std::uint64_t failed = 0;       ///< Questions that the subject failed.
  /** Worst values of the subject, indexed by MeasureKind; empty where it was never
   measured. */
  std::array<std::optional<WorstMeasure>, kMeasureKinds> worst;
  std::vector<FailedQuestion> first_failures;
};

/** The options of a sweep. */
struct SweepOptions {
  int jobs = 0;                   ///< Number of threads, as RunOptions::jobs.
  std::size_t failures_kept = 3;  ///< Largest size of SweepResult::first_failures.
  /** Called with the numbers of questions (done, total); may be empty. */
  std::function<void(std::size_t, std::size_t)> on_progress = nullptr;
};

/** Asks `oracles` every question of the series and judges the answers of the first, the
 subject, without a ledger. The result is deterministic and independent of the number of
 jobs. */
SweepResult Sweep(const QuestionSeries& series, std::span<const Oracle* const> oracles,
                  const SweepOptions& options = {});

/** Returns the faults of `subject` on the series, written for a person; empty where there
 are none. It states how many questions the subject failed. For the first of them it shows
 the file, every answer with its proof, and the command that repeats it. A series in which
 no bodies touch, or which the subject does not support, is a fault too. The answers of
 `references` are shown next to the subject's. */
std::string ComplaintAbout(const Oracle& subject, const QuestionSeries& series,
                           std::span<const Oracle* const> references = {});

}  // namespace touchstone
