#include "reports/writers/outcome.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "oracles/stated_tolerance.h"
#include "reports/text/told_apart.h"

namespace touchstone {
namespace {

bool IsMeasured(const Finding& finding) {
  return finding.verdict == Verdict::kPass || finding.verdict == Verdict::kFail ||
         finding.verdict == Verdict::kDisagree || finding.verdict == Verdict::kKnown;
}

void TakeWorse(const Finding*& worst, const Finding* candidate) {
  if (candidate == nullptr) return;
  if (worst == nullptr || RelativeToTolerance(*candidate) > RelativeToTolerance(*worst)) {
    worst = candidate;
  }
}

Outcome Sum(std::size_t scenario, std::size_t oracle, std::span<const Finding> findings) {
  Outcome outcome{.scenario = scenario, .oracle = oracle, .findings = findings};
  outcome.decisive = DecisiveOf(findings);
  if (outcome.decisive != nullptr) outcome.verdict = outcome.decisive->verdict;
  for (const Finding& finding : findings) {
    // The distance of another legal model from the truth is not a numerical error.
    if (IsMeasured(finding) && RecognisedModelOf(finding).empty())
      TakeWorse(outcome.worst, &finding);
  }
  if (outcome.verdict != Verdict::kPass) return outcome;
  const auto unverified = std::find_if(
      findings.begin(), findings.end(),
      [](const Finding& finding) { return finding.verdict == Verdict::kUnsupported; });
  if (unverified != findings.end() && !IsVerified(findings)) {
    outcome.verdict = Verdict::kUnsupported;
    outcome.decisive = &*unverified;
  }
  return outcome;
}

}  // namespace

int VerdictCounts::failed() const {
  int sum = 0;
  for (int i = 0; i < kVerdicts; ++i) {
    if (IsFailure(static_cast<Verdict>(i))) sum += counts_[static_cast<std::size_t>(i)];
  }
  return sum;
}

int VerdictCounts::total() const {
  int sum = 0;
  for (const int count : counts_) sum += count;
  return sum;
}

bool CountsAsFailure(const Outcome& outcome, const RunReport& report,
                     const FailureRule& rule) {
  return std::ranges::any_of(outcome.findings, [&](const Finding& finding) {
    return CountsAsFailure(finding, report, rule);
  });
}

std::string RelativeInWords(const Finding& finding) {
  const double relative = RelativeToTolerance(finding);
  if (std::isfinite(relative)) return fmt::format("{:.2g} × tolerance", relative);
  return fmt::format("{:.3g} where {:.3g} is allowed", finding.value, finding.tolerance);
}

std::vector<Outcome> OutcomesOf(const RunReport& report) {
  std::vector<Outcome> outcomes;
  const std::size_t questions = QuestionCount(report);
  outcomes.reserve(questions * report.oracles.size());
  const std::span<const Finding> all = report.findings;
  std::size_t at = 0;
  for (std::size_t s = 0; s < questions; ++s) {
    for (std::size_t o = 0; o < report.oracles.size(); ++o) {
      const std::size_t begin = at;
      while (at < all.size() && all[at].scenario == IdOf(report, s) &&
             all[at].oracle == report.oracles[o].name) {
        ++at;
      }
      outcomes.push_back(Sum(s, o, all.subspan(begin, at - begin)));
      outcomes.back().asked = Answers(report, o, s);
    }
  }
  return outcomes;
}

std::string_view GroupOf(std::string_view scenario_id) {
  const std::size_t slash = scenario_id.rfind('/');
  return slash == std::string_view::npos ? scenario_id : scenario_id.substr(0, slash);
}

void Count(const Outcome& outcome, VerdictCounts& counts) {
  ++counts[outcome.verdict];
  if (outcome.verdict == Verdict::kUndecidable && outcome.decisive != nullptr)
    ++counts[outcome.decisive->undecided];
}

std::string VerdictInWords(const Outcome& outcome) {
  std::string words(NameOf(outcome.verdict));
  if (outcome.verdict == Verdict::kUndecidable && outcome.decisive != nullptr)
    words += fmt::format(": {}", NameOf(outcome.decisive->undecided));
  return words;
}

std::string UndecidedInWords(const VerdictCounts& counts) {
  std::string words;
  for (int i = 0; i < kUndecided; ++i) {
    const auto undecided = static_cast<Undecided>(i);
    if (counts[undecided] == 0) continue;
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", counts[undecided],
                         NameOf(undecided));
  }
  return words;
}

void Tally::Add(const Outcome& outcome) {
  Count(outcome, outcomes);
  TakeWorse(worst, outcome.worst);
}

void Tally::Add(const Tally& other) {
  for (int i = 0; i < kVerdicts; ++i) {
    outcomes[static_cast<Verdict>(i)] += other.outcomes[static_cast<Verdict>(i)];
  }
  for (int i = 0; i < kUndecided; ++i) {
    const auto undecided = static_cast<Undecided>(i);
    outcomes[undecided] += other.outcomes[undecided];
  }
  TakeWorse(worst, other.worst);
}

std::vector<GroupTally> TallyByGroup(const RunReport& report,
                                     std::span<const Outcome> outcomes) {
  std::vector<GroupTally> groups;
  for (std::size_t s = 0; s < QuestionCount(report); ++s) {
    const std::string_view group = GroupOf(IdOf(report, s));
    if (groups.empty() || groups.back().group != group) {
      groups.push_back(
          {std::string(group), 0, std::vector<Tally>(report.oracles.size())});
    }
    ++groups.back().scenarios;
    for (std::size_t o = 0; o < report.oracles.size(); ++o) {
      groups.back().oracles[o].Add(outcomes[s * report.oracles.size() + o]);
    }
  }
  return groups;
}

std::vector<Tally> TallyByOracle(const RunReport& report,
                                 std::span<const Outcome> outcomes) {
  std::vector<Tally> tallies(report.oracles.size());
  for (const Outcome& outcome : outcomes) tallies[outcome.oracle].Add(outcome);
  return tallies;
}

std::string StatedTolerances(const RunReport& report) {
  std::string lines;
  for (const OracleInfo& oracle : report.oracles) {
    if (oracle.tolerance.IsZero()) continue;
    lines += fmt::format("Granted to {} beyond rounding: {}, stated by {}\n", oracle.name,
                         ToString(oracle.tolerance), oracle.tolerance.by);
  }
  return lines;
}

std::string WorldSetups(const RunReport& report) {
  std::string lines;
  for (const OracleInfo& oracle : report.oracles) {
    if (oracle.setup.IsDefault()) continue;
    lines += fmt::format("Worlds of {}: {}\n", oracle.name,
                         ToString(oracle.setup, oracle.parameters));
  }
  return lines;
}

std::string Quantity(double value, std::string_view unit) {
  return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string_view RecognisedModelOf(const Outcome& outcome) {
  for (const Finding& finding : outcome.findings) {
    const std::string_view model = RecognisedModelOf(finding);
    if (!model.empty()) return model;
  }
  return "";
}

const Finding* FailureAsShippedOnly(const Outcome& outcome) {
  if (outcome.verdict != Verdict::kPass) return nullptr;
  const auto found =
      std::ranges::find(outcome.findings, Shipped::kShippedOnly, &Finding::shipped);
  return found == outcome.findings.end() ? nullptr : &*found;
}

std::string_view ReasonOf(const RunReport& report, const Outcome& outcome) {
  if (outcome.verdict != Verdict::kUnsupported) return "";
  const std::size_t contacts = report.scenarios.size();
  const bool is_world = outcome.scenario >= contacts;
  if (!outcome.asked)
    return is_world ? "simulates no worlds" : "answers no contact queries";
  const std::string& reason =
      is_world
          ? report.worlds[outcome.scenario - contacts].trajectories[outcome.oracle].reason
          : report.scenarios[outcome.scenario].answers[outcome.oracle].reason;
  // If a motion leaves a claim nothing to judge, the reason is in the claim's finding.
  if (!reason.empty() || outcome.decisive == nullptr) return reason;
  return outcome.decisive->proof;
}

std::string WhyNotExamined(const RunReport& report, std::span<const Outcome> outcomes) {
  if (IsSubjectExamined(report)) return "";
  std::set<std::string> reasons;
  for (const Outcome& outcome : outcomes) {
    if (outcome.oracle != 0) continue;
    std::string_view reason = ReasonOf(report, outcome);
    if (reason.ends_with('.')) reason.remove_suffix(1);
    reasons.insert(fmt::format("{}{}{}", VerdictInWords(outcome),
                               reason.empty() ? "" : ": ", reason));
  }
  return fmt::format("{} was not examined: {}", report.subject, fmt::join(reasons, "; "));
}

std::string FailedReferences(const RunReport& report, std::span<const Outcome> outcomes) {
  std::vector<std::string_view> names;
  for (const Outcome& outcome : outcomes) {
    if (outcome.oracle == 0 || !IsFailure(outcome.verdict)) continue;
    const std::string& name = report.oracles[outcome.oracle].name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string Sentence(const Finding& finding) {
  const std::string_view model = RecognisedModelOf(finding);
  std::string text = fmt::format("{}: {}", finding.oracle, NameOf(finding.verdict));
  // The verdict says that there is no usable answer.
  if (finding.grade != Grade::kNone && finding.grade != Grade::kUnusable)
    text += fmt::format(", {}", NameOf(finding.grade));
  if (finding.verdict == Verdict::kUndecidable) {
    text +=
        fmt::format(", {}, in {}", NameOf(finding.undecided), NameOf(finding.measure));
    if (!finding.tolerance_because.empty())
      text += fmt::format(": {}", finding.tolerance_because);
  }
  if (!model.empty()) text += fmt::format(", recognised as {}", model);
  if (IsMeasured(finding)) {
    const std::string_view unit = UnitOf(finding.measure);
    const std::string_view space = unit.empty() ? "" : " ";
    const auto [value, tolerance, _] = TellApart(finding.value, finding.tolerance, 3);
    text += fmt::format(" in {}, {}{}{} where {}{}{} is allowed", NameOf(finding.measure),
                        value, space, unit, tolerance, space, unit);
    if (!model.empty()) text += fmt::format(" by the law {}", finding.law);
    if (!finding.tolerance_because.empty()) {
      text += fmt::format(" ({})", finding.tolerance_because);
    }
    if (IsWithinSafety(finding)) {
      text += fmt::format(", within the factor of {:.2g} for safety in that tolerance",
                          finding.safety);
    }
  }
  if (!finding.proof.empty()) text += fmt::format(". Proof: {}", finding.proof);
  if (finding.cause != Cause::kNone && model.empty()) {
    text += fmt::format("{} Cause: {}", text.ends_with('.') ? "" : ".",
                        NameOf(finding.cause));
    if (!finding.cause_because.empty())
      text += fmt::format(", {}", finding.cause_because);
  }
  if (finding.shipped != Shipped::kNotAsked) {
    std::string whose(NameOf(finding.shipped));
    whose[0] = static_cast<char>(std::toupper(whose[0]));
    text += fmt::format("{} {}: {}", text.ends_with('.') ? "" : ".", whose,
                        finding.shipped_because);
  }
  if (!text.ends_with('.')) text += '.';
  return text;
}

}  // namespace touchstone
