#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/run.h"
#include "scenarios/generators/generate.h"

namespace touchstone {

/** A seeded series of generated questions: the same on every machine. */
struct QuestionSeries {
  Family family = Family::kRandom;
  ShapeKind A = ShapeKind::kBox;
  ShapeKind B = ShapeKind::kBox;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< Index of the first question.
  std::uint64_t count = 1000;
};

/** Returns question `index` of the series as a scenario,
 * "sweep/random/box_box/seed_1/0...42". */
Scenario ScenarioAt(const QuestionSeries& series, std::uint64_t index);

/** Returns the command line that asks question `index` again. */
std::string ReplayOf(const QuestionSeries& series, std::uint64_t index);

/** The largest value of a measure relative to its tolerance. */
struct WorstMeasure {
  double relative = 0;      ///< Multiple of the tolerance. [-]
  double value = 0;         ///< In the measure's unit.
  std::uint64_t index = 0;  ///< Of the question.
};

/** A question that the subject failed, with everything that was said about it. */
struct FailedQuestion {
  std::uint64_t index;
  RunReport report;  ///< Of this one question.
};

/** What a sweep found. A sweep that touched nothing has verified nothing. */
struct SweepResult {
  std::uint64_t asked = 0;
  std::uint64_t touching = 0;     ///< Certified.
  std::uint64_t undecided = 0;    ///< Touching to within the rounding of the input.
  std::uint64_t unsupported = 0;  ///< By the subject.
  std::uint64_t failed = 0;       ///< By the subject.
  /** By MeasureKind, of the subject; empty where it was never measured. */
  std::array<std::optional<WorstMeasure>, kMeasureKinds> worst;
  std::vector<FailedQuestion> first_failures;
};

/** How to sweep. */
struct SweepOptions {
  int jobs = 0;                   ///< As RunOptions::jobs.
  std::size_t failures_kept = 3;  ///< At most so many of SweepResult::first_failures.
  /** Called with (done, total) questions; may be empty. */
  std::function<void(std::size_t, std::size_t)> on_progress = nullptr;
};

/** Asks `oracles` every question of the series and judges the answers of the first, the
 subject, without a ledger. Deterministic whatever the number of jobs. */
SweepResult Sweep(const QuestionSeries& series, std::span<const Oracle* const> oracles,
                  const SweepOptions& options = {});

/** Returns what is wrong with `subject` on the series, for a person: how many questions
 it failed, and of the first the file, every answer with its proof, and how to ask it
 again. Empty where nothing is wrong. That none of the questions touched, or that the
 subject supports none, is wrong too. The answers of `references` are shown beside. */
std::string ComplaintAbout(const Oracle& subject, const QuestionSeries& series,
                           std::span<const Oracle* const> references = {});

}  // namespace touchstone
