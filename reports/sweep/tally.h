#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "reports/finding/finding.h"
#include "reports/sweep/sketch.h"

namespace touchstone {

/** A quantity that is measured: a measure and, for a motion, the law that predicts it. */
struct Measurand {
  MeasureKind measure;
  std::string law = {};  ///< Same as Finding::law.

  auto operator<=>(const Measurand&) const = default;
};

/** The properties by which findings are counted. */
struct FindingKind {
  MeasureKind measure;
  Verdict verdict;
  Grade grade;
  Cause cause;
  std::string law = {};     ///< Same as Finding::law.
  std::string ending = {};  ///< EndingOf() the finding.
  /** Whether the bodies of a contact question touch or may touch; false for worlds. Tells
   a missed contact from a false one, and a depth from a distance. */
  bool touching = false;

  auto operator<=>(const FindingKind&) const = default;
};

using FindingCounts = std::map<FindingKind, std::uint64_t>;

/** A finding that is among the worst of its measure. */
struct WorstFinding {
  std::uint64_t question;  ///< Index in the series.
  double value;            ///< In the measure's unit.
  double tolerance;        ///< In the measure's unit.
  double tolerances;       ///< Value as a multiple of the tolerance. [-]
  double share;            ///< The value over the size of the question. [-]
  Verdict verdict;
  Grade grade;

  bool operator==(const WorstFinding&) const = default;
};

/** Returns whether `a` is worse: by tolerances, then by share, then the earlier one. */
bool IsWorse(const WorstFinding& a, const WorstFinding& b);

/** A question that an oracle failed. */
struct FailedQuestion {
  std::uint64_t question;  ///< Index in the series.
  FindingKind kind;        ///< Kind of the decisive finding.
  double value;            ///< In the measure's unit.
  double tolerance;        ///< In the measure's unit.
  double share;            ///< The value over the size of the question. [-]
  std::string proof;
  std::string scenario;  ///< The question as a scenario file.

  bool operator==(const FailedQuestion&) const = default;
};

/** The number of findings that are kept per oracle, series and measurand as the worst. */
inline constexpr std::size_t kWorstKept = 5;

/** The number of failed questions that are kept per oracle, series and kind of decisive
 finding, the gravest. The others are only counted. */
inline constexpr std::size_t kFailuresKept = 2;

/** The results of one oracle on questions of one series. */
struct OracleTally {
  std::uint64_t asked = 0;               ///< Number of questions.
  std::uint64_t touching = 0;            ///< Contacts certified as touching.
  std::uint64_t undecided = 0;           ///< Contacts touching to within input rounding.
  std::uint64_t verified = 0;            ///< Answers that IsVerified().
  std::uint64_t verified_touching = 0;   ///< Those to questions certified as touching.
  FindingCounts findings;                ///< Every measure of every answer.
  FindingCounts answers;                 ///< The decisive finding of every answer.
  std::map<Measurand, Sketch> sketches;  ///< Values that the truth could decide.
  std::map<Measurand, std::vector<WorstFinding>> worst;         ///< The worst first.
  std::map<FindingKind, std::vector<FailedQuestion>> failures;  ///< The gravest first.

  bool operator==(const OracleTally&) const = default;
};

/** The results of questions of one series. Its size has a bound, however many they are.
 */
struct SeriesTally {
  std::vector<OracleTally> oracles;  ///< Indexed as SweepPlan::subjects.

  bool operator==(const SeriesTally&) const = default;
};

/** Inserts `finding` into the list of the worst. */
void Insert(const WorstFinding& finding, std::vector<WorstFinding>& worst);

/** Returns whether a failure of question `question` with that share would be kept among
 `failures`, those of its kind. The gravest has the largest share and, of equal ones, the
 least index. */
bool IsKept(std::uint64_t question, double share,
            const std::vector<FailedQuestion>& failures);

/** Inserts `failure` into the failures of its kind. */
void Insert(FailedQuestion failure, std::vector<FailedQuestion>& failures);

/** Returns the kept failure of the gravest grade and in it of the largest share; of equal
 ones the first. Null if none failed. */
const FailedQuestion* GravestFailure(const OracleTally& tally);

/** Returns the number of answers that fail. */
std::uint64_t FailureCount(const OracleTally& tally);

/** Adds the results of other questions of the same series and oracles. Associative and
 commutative: the sum depends on neither order nor grouping. */
void Merge(const SeriesTally& other, SeriesTally& tally);

}  // namespace touchstone
