#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/finding/decisive.h"
#include "reports/run_report.h"

namespace touchstone {

inline constexpr int kVerdicts = static_cast<int>(Verdict::kInvalid) + 1;

inline constexpr int kUndecided = static_cast<int>(Undecided::kOpposed) + 1;

/** Numbers of findings or outcomes per verdict. */
class VerdictCounts {
 public:
  int& operator[](Verdict verdict) { return counts_[static_cast<std::size_t>(verdict)]; }
  int operator[](Verdict verdict) const {
    return counts_[static_cast<std::size_t>(verdict)];
  }
  /** Returns the number of verdicts that fail a run: proved wrong outside the ledger,
   disagreeing, without an answer, or invalid. */
  int failed() const;
  int total() const;

  /** Numbers of undecidable outcomes per reason. */
  int& operator[](Undecided undecided) {
    return undecided_[static_cast<std::size_t>(undecided)];
  }
  int operator[](Undecided undecided) const {
    return undecided_[static_cast<std::size_t>(undecided)];
  }

 private:
  std::array<int, kVerdicts> counts_{};
  std::array<int, kUndecided> undecided_{};
};

/** The result of one oracle in one scenario: the sum of its findings. */
struct Outcome {
  std::size_t scenario;               ///< Index of the question, see IdOf(report, i).
  std::size_t oracle;                 ///< Index into RunReport::oracles.
  std::span<const Finding> findings;  ///< Findings of this oracle, ordered by measure.
  /** Most severe verdict of the findings. kUnsupported if no measure applied, or if the
   only finding that passed is that the oracle answered, and a law had nothing to judge.
 */
  Verdict verdict = Verdict::kUnsupported;
  /** The finding that decides the verdict, see DecisiveOf(). Null without findings. */
  const Finding* decisive = nullptr;
  /** Finding with the largest value relative to its tolerance, whatever its verdict. Null
   if nothing was measured against a tolerance. */
  const Finding* worst = nullptr;
  /** False if the oracle answers no questions of this kind. It is then not queried, and
   counted as unsupported. */
  bool asked = true;
};

/** Returns whether any finding of an outcome of `report` is a failure that counts. */
bool CountsAsFailure(const Outcome& outcome, const RunReport& report,
                     const FailureRule& rule);

/** Returns the value of `finding` relative to its tolerance: "2.1 × tolerance", or "1
 where 0 is allowed" if the tolerance is zero. */
std::string RelativeInWords(const Finding& finding);

/** Returns the outcome of every oracle in every scenario: scenario s and oracle o are at
 s * oracles.size() + o. The outcomes refer to `report`. */
std::vector<Outcome> OutcomesOf(const RunReport& report);

/** Returns the legal model, other than that of the truth, that a motion is recognised to
 follow, see RecognisedModelOf(finding). Empty if none. */
std::string_view RecognisedModelOf(const Outcome& outcome);

/** Returns the first measure by which an answer that passes here fails as the engine
 ships; null if there is none. */
const Finding* FailureAsShippedOnly(const Outcome& outcome);

/** Returns the reason of an `unsupported` outcome; empty for any other verdict. */
std::string_view ReasonOf(const RunReport& report, const Outcome& outcome);

/** Returns e.g. "cookbook was not examined: unsupported: it has no cones". Empty if any
 answer of the subject was verified. */
std::string WhyNotExamined(const RunReport& report, std::span<const Outcome> outcomes);

/** Returns the names of the references that fail, separated by commas; empty if none. */
std::string FailedReferences(const RunReport& report, std::span<const Outcome> outcomes);

/** Returns the folder of a scenario id: "contact/box_box" for
 * "contact/box_box/face_face".
 */
std::string_view GroupOf(std::string_view scenario_id);

/** The outcomes of one oracle in one group of scenarios, or in all of them. */
struct Tally {
  VerdictCounts outcomes;
  const Finding* worst = nullptr;  ///< Same as Outcome::worst.

  void Add(const Outcome& outcome);
  void Add(const Tally& other);
};

/** One group of scenarios, with a tally per oracle. */
struct GroupTally {
  std::string group;
  int scenarios = 0;
  std::vector<Tally> oracles;  ///< Indexed as RunReport::oracles.
};

/** Returns the groups of `report` in the order of its scenarios. */
std::vector<GroupTally> TallyByGroup(const RunReport& report,
                                     std::span<const Outcome> outcomes);

/** Returns the tally of every oracle over all scenarios. */
std::vector<Tally> TallyByOracle(const RunReport& report,
                                 std::span<const Outcome> outcomes);

/** Returns the verdict of an outcome with its reason if it is undecidable: "pass",
 "undecidable: truth unknown". */
std::string VerdictInWords(const Outcome& outcome);

/** Returns the numbers of undecidable outcomes per reason, without those that are zero:
 "3 sign known and agreed, 1 unverified". Empty if there are none. */
std::string UndecidedInWords(const VerdictCounts& counts);

/** Adds one outcome to `counts`. */
void Count(const Outcome& outcome, VerdictCounts& counts);

/** Returns the finding as one line of text, without the scenario: oracle, verdict,
 measure, value, tolerance and its origin, proof, cause, and whether it fails as shipped.
 */
std::string Sentence(const Finding& finding);

/** Returns a line for each oracle whose answers are judged with a stated tolerance, and
 who states it. Empty if there is none. */
std::string StatedTolerances(const RunReport& report);

/** Returns a line for each oracle whose worlds are set up otherwise than its adapter
 does, with the values. Empty if there is none. */
std::string WorldSetups(const RunReport& report);

/** Returns `value` with its unit, to three digits: "1.23e-05 m". */
std::string Quantity(double value, std::string_view unit);

}  // namespace touchstone
