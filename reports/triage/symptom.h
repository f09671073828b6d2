#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/finding/finding.h"
#include "reports/sweep/tally.h"
#include "scenarios/shape.h"

namespace touchstone {

/** Returns whether a verdict is a proved fault: an answer that merely differs from those
 of other oracles is none. */
bool IsFault(Verdict verdict);

/** Returns "box and sphere", whatever the order. */
std::string PairName(ShapeKind a, ShapeKind b);

/** The failed answers of one oracle that look alike: they have one decisive measure and
 one ending, and belong to one pair of shapes in either order, or one family of worlds. */
struct Symptom {
  /** The properties that its answers share. */
  struct Key {
    std::string oracle;
    std::string of;  ///< PairName(), or a family of worlds.
    MeasureKind measure;
    Verdict verdict;
    std::string law;        ///< Same as Finding::law.
    std::string ending;     ///< EndingOf() the finding.
    bool touching = false;  ///< Same as FindingKind::touching.

    auto operator<=>(const Key&) const = default;
  };
  Key key;
  /** At most four of those that were kept: of the gravest grade first, and of one grade
   the plainest, see PlainnessOf(). */
  std::vector<FailedQuestion> kept;
  /** The number of answers that show it, by Asked::what. */
  std::map<std::string, std::uint64_t> failed;
  std::map<Grade, std::uint64_t> grades;  ///< The same by the grade of the fault.
};

/** The symptoms found so far. */
using Symptoms = std::map<Symptom::Key, Symptom>;

/** Returns `symptoms` with their keys, the gravest first: by grade, then by share.
 Each keeps four questions, see Symptom::kept. Leaves out those without a
 question.
 @pre The questions can be read. */
std::vector<Symptom> GravestFirst(const Symptoms& symptoms);

/** The kinds of A and B; empty for a world. */
using AskedPair = std::optional<std::pair<ShapeKind, ShapeKind>>;

/** Questions of one kind that an oracle was asked. */
struct Asked {
  std::string oracle;
  std::string what;  ///< "random, sphere and box", "the file poses.csv, …".
  AskedPair pair;
  std::uint64_t count = 0;  ///< Those that it did not call unsupported.
};

/** The failed answers of a sweep or a run, and the questions among which they were found.
 */
struct Failures {
  std::vector<Symptom> symptoms;  ///< The GravestFirst().
  std::vector<Asked> asked;
  std::uint64_t failed = 0;  ///< Answers of all symptoms.
  /** Answers that merely differ from those of other oracles: alone that is no fault, and
   no symptom. */
  std::uint64_t unproved = 0;
  /** Answers of a run that did not fail when they were asked for again, alone. */
  std::uint64_t vanished = 0;
  std::uint64_t unasked = 0;  ///< Answers of a run that there was no time to ask for.
};

/** Adds the failed answers of `tally` to symptoms of `oracle`, and counts them.
 @param of Symptom::Key::of of its questions.
 @param what Asked::what of its questions. */
void AddAnswers(const OracleTally& tally, const std::string& oracle,
                const std::string& of, const std::string& what, Symptoms& symptoms,
                Failures& failures);

}  // namespace touchstone
