#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Settings for timing contact queries. */
struct ContactBenchSettings {
  std::uint64_t count = 20000;  ///< Questions per pair.
  std::uint64_t sample = 500;   ///< Number of questions checked against the truth.
  std::uint64_t seed = 1;
};

/** Accuracy of the answers to the sample. */
struct SampleAccuracy {
  double worst_error = 0;  ///< Largest certain error of the separation. [m]
  int measured = 0;        ///< Answers with a separation.
  int wrong_verdicts = 0;  ///< Touching reported where certainly apart, or the reverse.
  int without_answer = 0;
};

/** The result of an oracle. */
struct TimedQueries {
  const Oracle* oracle;
  std::optional<double> nanoseconds;  ///< Per query; empty if the oracle is not timed.
  SampleAccuracy accuracy;
};

/** The results for a pair of shapes. */
struct ContactBench {
  std::size_t queries = 0;   ///< Number of questions.
  std::size_t sample = 0;    ///< Number of questions checked against the truth.
  std::size_t touching = 0;  ///< Number of those that are certainly touching.
  std::vector<TimedQueries> rows;
};

/** Times random contact queries of A and B in each of `oracles` that supports the pair.
 The time is the median of several passes over the same poses, with the engine objects
 created beforehand; that of an external oracle is the time until its program has
 answered, messages included. The oracles take turns, so that a temporary slowdown of the
 machine affects all of them alike. No rows, and no queries, if no oracle supports the
 pair. */
ContactBench BenchContacts(ShapeKind A, ShapeKind B,
                           std::span<const Oracle* const> oracles,
                           const ContactBenchSettings& settings);

}  // namespace touchstone
