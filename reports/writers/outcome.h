#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run_report.h"

namespace touchstone {

inline constexpr int kVerdicts = static_cast<int>(Verdict::kInvalid) + 1;

/** How many findings or outcomes have each verdict. */
class VerdictCounts {
 public:
  int& operator[](Verdict verdict) { return counts_[static_cast<std::size_t>(verdict)]; }
  int operator[](Verdict verdict) const {
    return counts_[static_cast<std::size_t>(verdict)];
  }
  /** Returns the number of those that fail a run: proved wrong outside the ledger,
   disagreeing, without an answer, or invalid. */
  int failed() const;
  int total() const;

 private:
  std::array<int, kVerdicts> counts_{};
};

/** What one oracle did with one scenario: the sum of its findings. */
struct Outcome {
  std::size_t scenario;               ///< Of the question, see IdOf(report, i).
  std::size_t oracle;                 ///< Index into RunReport::oracles.
  std::span<const Finding> findings;  ///< Its own, by measure.
  /** The gravest of its findings; kUnsupported where no measure applied, or where all
   that passed is that there was an answer, in which a law found nothing to judge. */
  Verdict verdict = Verdict::kUnsupported;
  /** The finding that has the verdict; among several the one that is the simplest to
   check, of the first measure in their enumeration; null without findings. */
  const Finding* decisive = nullptr;
  /** The finding largest relative to its tolerance, whatever its verdict; null where
   nothing was measured against a tolerance. */
  const Finding* worst = nullptr;
  /** False where the oracle answers no question of this kind: not asked, and counted as
   unsupported. */
  bool asked = true;
};

/** Returns the value of `finding` as a multiple of its tolerance; infinite for NaN, and
 for a value above a tolerance of zero. [-] */
double RelativeToTolerance(const Finding& finding);

/** Returns how far `finding` is from its tolerance: "2.1 × tolerance", or, where the
 tolerance is zero, "1 where 0 is allowed". */
std::string RelativeInWords(const Finding& finding);

/** Returns the outcome of every oracle in every scenario: scenario s and oracle o are at
 s * oracles.size() + o. The outcomes refer to `report`. */
std::vector<Outcome> OutcomesOf(const RunReport& report);

/** Returns the legal model that a motion is recognised to follow instead of the truth's,
 see RecognisedModelOf(finding); empty: none. */
std::string_view RecognisedModelOf(const Outcome& outcome);

/** Returns why an outcome is `unsupported`; empty where it is another. */
std::string_view ReasonOf(const RunReport& report, const Outcome& outcome);

/** Returns "cookbook was not examined: unsupported: it has no cones"; empty where
 something of the subject was held against anything. */
std::string WhyNotExamined(const RunReport& report, std::span<const Outcome> outcomes);

/** Returns the names of the references that fail, with commas; empty where none does. */
std::string FailedReferences(const RunReport& report, std::span<const Outcome> outcomes);

/** Returns the folder of a scenario id: "contact/box_box" of "contact/box_box/face_face".
 */
std::string_view GroupOf(std::string_view scenario_id);

/** The outcomes of one oracle in one group of scenarios, or in all of them. */
struct Tally {
  VerdictCounts outcomes;
  const Finding* worst = nullptr;  ///< As Outcome::worst.

  void Add(const Outcome& outcome);
  void Add(const Tally& other);
};

/** One group of scenarios, with a tally per oracle. */
struct GroupTally {
  std::string group;
  int scenarios = 0;
  std::vector<Tally> oracles;  ///< In the order of RunReport::oracles.
};

/** Returns the groups of `report` in the order of its scenarios. */
std::vector<GroupTally> TallyByGroup(const RunReport& report,
                                     std::span<const Outcome> outcomes);

/** Returns the tally of every oracle over all scenarios. */
std::vector<Tally> TallyByOracle(const RunReport& report,
                                 std::span<const Outcome> outcomes);

/** Returns the finding as a sentence: who, which measure, value, tolerance and its
 origin, cause, and the proof. One line, without the scenario. */
std::string Sentence(const Finding& finding);

/** Returns `value` with its unit, to three digits: "1.23e-05 m". */
std::string Quantity(double value, std::string_view unit);

}  // namespace touchstone
