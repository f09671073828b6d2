#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "reports/sweep/sweep_file.h"

namespace touchstone {

/** The properties by which failures are clustered. */
struct FailureKind {
  MeasureKind measure;
  Cause cause;
  std::string law;     ///< Same as Finding::law.
  std::string ending;  ///< EndingOf() the finding.

  auto operator<=>(const FailureKind&) const = default;
};

/** Failures of one kind. */
struct FailureCluster {
  std::uint64_t count = 0;
  Grade grade = Grade::kNone;           ///< The gravest.
  std::optional<FailedQuestion> worst;  ///< The one of the largest share that is kept.
  std::size_t series = 0;               ///< The series of `worst`.
};

/** The results of one subject, over all series. */
struct SubjectSummary {
  std::uint64_t answers = 0;      ///< Answers to questions that it supports.
  std::uint64_t unsupported = 0;  ///< Questions that it does not support.
  /** Verified answers; of generated contact questions, those to questions that touch. */
  std::uint64_t examined = 0;
  std::uint64_t failed = 0;
  bool fails = false;  ///< Whether any failure counts for the exit code.
  std::map<FailureKind, FailureCluster> clusters;
};

/** Prints one row per series and subject of a sweep to standard output. Returns the sums
 per subject. Failures count for the exit code if they are graver than `above`. */
std::vector<SubjectSummary> PrintSweepTable(const SweepFile& file, Grade above);

/** Prints the failures of each subject by kind, the most frequent first, with the
 commands that repeat them. */
void PrintFailureClusters(const SweepFile& file,
                          const std::vector<SubjectSummary>& subjects);

}  // namespace touchstone
