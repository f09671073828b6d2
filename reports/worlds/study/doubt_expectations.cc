#include "reports/worlds/study/doubt_expectations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/study/judge_expectation.h"
#include "reports/worlds/study/untouched.h"
#include "scenarios/diagnostic.h"

namespace touchstone {
namespace {

/** The share of their error to which engines that are right agree with each other. */
constexpr double kAgreement = 0.1;

/** Two engines of different libraries that agree with each other. */
struct Agreement {
  std::size_t a;  ///< Index into the oracles.
  std::size_t b;
  double apart;  ///< In the unit of what is expected.
};

/** What all engines say about one expectation. */
class Expectation {
 public:
  Expectation(const WorldResult& result, std::span<const OracleInfo> oracles,
              std::size_t index)
      : result_(result),
        oracles_(oracles),
        index_(index),
        law_(fmt::format("expect[{}]", index)) {}

  /** Takes the findings about this expectation among those of the world. */
  void Take(std::span<Finding> findings) {
    for (Finding& finding : findings)
      if (finding.law == law_ && finding.verdict != Verdict::kUnsupported)
        findings_.push_back(&finding);
  }

  /** Withdraws the accusations if engines agree against the file. Returns the fault of
   the file, if it is shown to be at fault. */
  std::optional<std::string> Doubt() const {
    const bool is_met = std::ranges::any_of(findings_, [](const Finding* finding) {
      return finding->verdict != Verdict::kFail;
    });
    if (is_met) return std::nullopt;
    // Engines that miss a contact agree as well as engines that are right.
    std::vector<Finding*> evidence;
    for (Finding* finding : findings_)
      if (!MayMissWhatActs(OracleOf(*finding))) evidence.push_back(finding);
    if (const std::optional<Agreement> agreement = BestOf(evidence)) {
      Withdraw(InWords(*agreement));
      return FaultOfFile(*agreement);
    }
    if (const std::optional<Agreement> agreement = BestOf(findings_)) {
      Withdraw(InWords(*agreement) +
               ", as they would if nothing acted on it: either the file is wrong, or "
               "they miss what does");
    }
    return std::nullopt;
  }

 private:
  /** Returns those of two libraries that agree best; nothing if none agree. */
  std::optional<Agreement> BestOf(const std::vector<Finding*>& findings) const {
    std::optional<Agreement> best;
    for (const Finding* first : findings) {
      for (const Finding* second : findings) {
        const std::size_t a = OracleOf(*first);
        const std::size_t b = OracleOf(*second);
        if (oracles_[a].library == oracles_[b].library) continue;
        const std::optional<double> apart = Apart(a, b);
        if (!apart || !(*apart <= ToAgree(std::min(first->value, second->value))))
          continue;
        if (!best || *apart < best->apart) best = Agreement{a, b, *apart};
      }
    }
    return best;
  }

  std::string InWords(const Agreement& agreement) const {
    return fmt::format("{} and {} agree to {:.2g} {}", oracles_[agreement.a].name,
                       oracles_[agreement.b].name, agreement.apart,
                       UnitOf(findings_[0]->measure));
  }

  void Withdraw(std::string_view agree) const {
    for (Finding* finding : findings_) {
      finding->verdict = Verdict::kUndecidable;
      finding->undecided = Undecided::kUnknown;
      finding->grade = Grade::kNone;
      finding->cause = Cause::kNone;
      finding->cause_because.clear();
      finding->shipped = Shipped::kNotAsked;
      finding->shipped_because.clear();
      finding->study.reset();
      finding->proof.clear();
      finding->tolerance_because =
          fmt::format("no engine has what the file expects, and {}", agree);
    }
  }

  std::string FaultOfFile(const Agreement& agreement) const {
    std::string sentence = JudgedBy(agreement.a).proof;
    const std::size_t stop = sentence.find("; ");
    if (stop != std::string::npos) sentence.replace(stop, 2, ", but ");
    return fmt::format("{}: {}; none of {} engines meets this, and {}. Correct it.",
                       Place(), sentence, findings_.size(), InWords(agreement));
  }

  /** Returns how far apart engines with errors of at least `error` may be. A touch that
   never comes is infinitely late, and only another one like it agrees with it. */
  static double ToAgree(double error) {
    return std::isfinite(error) ? kAgreement * error : 0;
  }

  std::size_t OracleOf(const Finding& finding) const {
    const auto is_it = [&](const OracleInfo& info) {
      return info.name == finding.oracle;
    };
    return static_cast<std::size_t>(std::ranges::find_if(oracles_, is_it) -
                                    oracles_.begin());
  }

  const MotionExpectation& Stated() const {
    return result_.scenario.expectations[index_];
  }

  Motion MotionOf(std::size_t oracle) const {
    return {result_.scenario.world, oracles_[oracle], result_.trajectories[oracle]};
  }

  LawFinding JudgedBy(std::size_t oracle) const {
    return JudgeExpectation(MotionOf(oracle), Stated());
  }

  /** Returns how far b is off what a has. */
  std::optional<double> Apart(std::size_t a, std::size_t b) const {
    const std::optional<MotionExpectation> met = MetBy(MotionOf(a), Stated());
    if (!met) return std::nullopt;
    return JudgeExpectation(MotionOf(b), *met).value;
  }

  /** Returns whether oracle `o` leaves the body alone, up to the moment that decides,
   although something may act on it. */
  bool MayMissWhatActs(std::size_t o) const {
    const Motion motion = MotionOf(o);
    // Of a trajectory, the state that is farthest off.
    const Cited cited = JudgedBy(o).cited;
    double until = cited.time.value();
    if (std::holds_alternative<ExpectedTouch>(Stated().what)) {
      // A touch shows in the motion after it.
      const double touch = MetBy(motion, Stated())->time;
      if (std::isfinite(touch))
        until = std::max(until, touch) + SampleSpacing(motion.world);
    }
    const std::string& name = cited.names.front();
    return IsUntouched(motion, name, until) && MayBeTouched(motion, name, until);
  }

  std::string Place() const {
    const FilePlaces& places = result_.scenario.places;
    if (places.file.empty()) return result_.scenario.id;
    const Diagnostic at = ErrorAtValue(places, law_, "", "");
    return fmt::format("{}:{}:{}", at.file, at.line, at.column);
  }

  const WorldResult& result_;
  std::span<const OracleInfo> oracles_;
  std::size_t index_;
  std::string law_;
  std::vector<Finding*> findings_;
};

}  // namespace

std::vector<std::string> DoubtExpectations(const WorldResult& result,
                                           std::span<const OracleInfo> oracles,
                                           std::span<Finding> findings) {
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < result.scenario.expectations.size(); ++i) {
    Expectation expectation(result, oracles, i);
    expectation.Take(findings);
    if (std::optional<std::string> fault = expectation.Doubt())
      faults.push_back(*std::move(fault));
  }
  return faults;
}

}  // namespace touchstone
