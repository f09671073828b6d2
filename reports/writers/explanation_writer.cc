#include "reports/writers/explanation_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/text/counted.h"
#include "reports/text/format_vector.h"
#include "reports/worlds/study/run_claims.h"
#include "reports/worlds/study/universal_claims.h"
#include "reports/writers/describe.h"
#include "reports/writers/outcome.h"
#include "reports/writers/world_words.h"

namespace touchstone {
namespace {

std::string OneLine(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\n' ? ' ' : c;
  return line;
}

/** Returns a number of a table, a direction or a point, 0 where it is only rounding. */
double WithoutRounding(double value) {
  constexpr double kRounding = 1e-12;
  return std::abs(value) < kRounding ? 0.0 : value;
}

std::string Short(const Eigen::Vector3d& v) {
  return FormatVector(v.unaryExpr(&WithoutRounding), 6);
}

/** Returns the row of an answer, without the oracle's name. */
std::string RowOf(const ContactAnswer& answer, const ContactTruth& truth,
                  Verdict verdict) {
  std::string row = fmt::format("{:<12}", NameOf(verdict));
  if (answer.status != AnswerStatus::kAnswered) return row + OneLine(answer.reason);
  row += fmt::format(" {:<9}", answer.touching ? "touching" : "apart");
  if (answer.separation) {
    row += fmt::format("{:>20.12g} {:>9.2g}", *answer.separation,
                       LeastError(*answer.separation, truth));
  } else {
    row += fmt::format("{:>20} {:>9}", "-", "-");
  }
  return row + fmt::format(" {:>8} {}", answer.points.size(),
                           answer.n_AB_W ? Short(*answer.n_AB_W) : "no normal");
}

void WritePoints(const ContactAnswer& answer, std::ostream& out) {
  for (const ContactPoint& point : answer.points) {
    out << fmt::format("  {:>39} contact {:>20.12g} at {}\n", "", point.separation,
                       FormatVector(point.p_WC));
  }
}

/** Oracles that share a text. */
struct Alike {
  std::string text;
  std::vector<std::size_t> oracles;
};

/** Adds `oracle` to the group with the same text, or to a new one. */
void Add(std::vector<Alike>& groups, std::string text, std::size_t oracle) {
  auto same = std::find_if(groups.begin(), groups.end(),
                           [&](const Alike& group) { return group.text == text; });
  if (same == groups.end()) same = groups.insert(same, {std::move(text), {}});
  same->oracles.push_back(oracle);
}

/** Returns the names of all oracles of the group but the first. */
std::string Others(const RunReport& report, const Alike& group) {
  std::vector<std::string_view> names;
  for (const std::size_t o : group.oracles) names.push_back(report.oracles[o].name);
  return fmt::format("{}", fmt::join(names.begin() + 1, names.end(), ", "));
}

void WriteAnswers(const RunReport& report, const ScenarioResult& result,
                  std::span<const Outcome> outcomes, const ExplanationStyle& style,
                  std::ostream& out) {
  out << fmt::format("  {:<26} {:<12} {:<9}{:>20} {:>9} {:>8} {}\n", "oracle", "verdict",
                     "answer", "separation [m]", "error [m]", "contacts",
                     "normal A to B");
  std::vector<Alike> groups;
  for (std::size_t o = 0; o < outcomes.size(); ++o) {
    std::string row = RowOf(result.answers[o], result.truth, outcomes[o].verdict);
    if (style.everything) {
      groups.push_back({std::move(row), {o}});
    } else {
      Add(groups, std::move(row), o);
    }
  }
  for (const Alike& group : groups) {
    const std::size_t first = group.oracles.front();
    out << fmt::format("  {:<26} {}\n", report.oracles[first].name, group.text);
    if (group.oracles.size() > 1) out << "    likewise " << Others(report, group) << '\n';
    if (style.everything) WritePoints(result.answers[first], out);
  }
}

bool IsRight(const Outcome& outcome) {
  return outcome.verdict == Verdict::kPass;
}

bool IsWrong(const Outcome& outcome) {
  return IsFailure(outcome.verdict) || outcome.verdict == Verdict::kKnown;
}

/** Returns the grade of a finding and whether it shows as shipped, e.g. " (over 10 %, as
 set here only)"; empty if neither is known. */
std::string Bracketed(const Finding* finding) {
  if (finding == nullptr) return "";
  const std::string_view grade = NameOf(finding->grade);
  const bool fails = finding->shipped != Shipped::kShippedOnly;
  const std::string_view shipped = fails ? NameOf(finding->shipped) : "";
  if (grade.empty() && shipped.empty()) return "";
  return fmt::format(" ({}{}{})", grade, grade.empty() || shipped.empty() ? "" : ", ",
                     shipped);
}

std::string Names(const RunReport& report, std::span<const Outcome> outcomes,
                  bool (*selects)(const Outcome&)) {
  std::string names;
  for (const Outcome& outcome : outcomes) {
    if (!selects(outcome)) continue;
    names += (names.empty() ? "" : ", ") + report.oracles[outcome.oracle].name;
    names += Bracketed(outcome.decisive);
  }
  return names.empty() ? "none" : names;
}

/** Returns `text` with "it" in place of each `name` that is a word of its own. The texts
 of two oracles are then equal if only their names differ. */
std::string WithoutName(const std::string& text, std::string_view name) {
  const auto is_part_of_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/';
  };
  std::string without;
  std::size_t at = 0;
  for (std::size_t found; (found = text.find(name, at)) != std::string::npos;) {
    const std::size_t end = found + name.size();
    const bool alone = (found == 0 || !is_part_of_name(text[found - 1])) &&
                       (end == text.size() || !is_part_of_name(text[end]));
    without += text.substr(at, found - at) + std::string(alone ? "it" : name);
    at = end;
  }
  return without + text.substr(at);
}

bool IsRemarkable(const Finding& finding) {
  return finding.verdict != Verdict::kUnsupported &&
         (finding.verdict != Verdict::kPass || !RecognisedModelOf(finding).empty() ||
          finding.shipped == Shipped::kShippedOnly);
}

/** Returns the findings against an answer: the simplest proof and the names of the other
 wrong measures, or all proofs if `style` requests everything. */
std::string Charge(const Outcome& outcome, const ExplanationStyle& style) {
  std::string text;
  std::string also;
  for (const Finding& finding : outcome.findings) {
    // A recognised model is printed next to its number.
    if (!IsRemarkable(finding) ||
        (!style.everything && finding.verdict == Verdict::kPass)) {
      continue;
    }
    if (style.everything || &finding == outcome.decisive) {
      text += fmt::format("  {}\n", Sentence(finding));
    } else if (finding.verdict != Verdict::kUndecidable) {
      also += fmt::format("{}{} {}", also.empty() ? "" : ", ", NameOf(finding.measure),
                          RelativeInWords(finding));
    }
  }
  return also.empty() ? text : fmt::format("{}    also: {}\n", text, also);
}

/** Writes the reasons of the ledger for an oracle, each once. */
void WriteLedgerReasons(const RunReport& report, const Outcome& outcome,
                        std::ostream& out) {
  std::vector<std::string_view> reasons;
  for (const Finding& finding : outcome.findings) {
    if (!finding.ledger_entry) continue;
    const auto index = static_cast<std::size_t>(*finding.ledger_entry);
    const std::string_view reason = report.ledger.entries[index].reason;
    if (std::find(reasons.begin(), reasons.end(), reason) != reasons.end()) continue;
    reasons.push_back(reason);
    out << fmt::format("    Ledger entry for {} ({}): {}\n",
                       report.oracles[outcome.oracle].name,
                       CausesOf(report.ledger.entries[index]), reason);
  }
}

void WriteCharges(const RunReport& report, std::span<const Outcome> outcomes,
                  const ExplanationStyle& style, std::ostream& out) {
  std::vector<Alike> groups;
  for (const Outcome& outcome : outcomes) {
    const std::string charge = Charge(outcome, style);
    if (!charge.empty())
      Add(groups, WithoutName(charge, report.oracles[outcome.oracle].name),
          outcome.oracle);
  }
  for (const Alike& group : groups) {
    out << Charge(outcomes[group.oracles.front()], style);
    if (group.oracles.size() > 1) out << "    likewise " << Others(report, group) << '\n';
    for (const std::size_t o : group.oracles)
      WriteLedgerReasons(report, outcomes[o], out);
  }
}

void WriteVerdict(const RunReport& report, std::span<const Outcome> outcomes,
                  std::ostream& out) {
  out << "Right: " << Names(report, outcomes, IsRight)
      << "\nWrong: " << Names(report, outcomes, IsWrong) << '\n';
  std::map<Undecided, std::vector<std::string_view>> undecided;
  for (const Outcome& outcome : outcomes) {
    if (outcome.verdict == Verdict::kUndecidable)
      undecided[outcome.decisive->undecided].push_back(
          report.oracles[outcome.oracle].name);
  }
  for (const auto& [reason, names] : undecided)
    out << fmt::format("Undecided, {}: {}\n", NameOf(reason), fmt::join(names, ", "));
  std::map<std::string_view, std::vector<std::string_view>> models;
  for (const Outcome& outcome : outcomes) {
    const std::string_view model = RecognisedModelOf(outcome);
    if (!model.empty()) models[model].push_back(report.oracles[outcome.oracle].name);
  }
  for (const auto& [model, names] : models)
    out << fmt::format("Follows another legal model, {}: {}\n", model,
                       fmt::join(names, ", "));
}

void WriteScenario(const RunReport& report, const ScenarioResult& result,
                   std::span<const Outcome> outcomes, const ExplanationStyle& style,
                   std::ostream& out) {
  const Scenario& scenario = result.scenario;
  out << scenario.id << ": " << scenario.title << '\n';
  if (!scenario.source.empty()) out << "  source: " << OneLine(scenario.source) << '\n';
  out << "  A: " << Describe(scenario.contact.A)
      << "\n  B: " << Describe(scenario.contact.B) << "\n\nTruth. "
      << Describe(result.scenario.contact, result.truth) << "\n\n";
  WriteVerdict(report, outcomes, out);
  out << '\n';
  WriteAnswers(report, result, outcomes, style, out);
  out << '\n';
  WriteCharges(report, outcomes, style, out);
}

/** The origins of tolerances. Each is printed once, below the table that refers to it by
 number. */
class Origins {
 public:
  /** Returns the number of `because`, starting at 1. */
  std::size_t NumberOf(const std::string& because) {
    const auto found = std::find(texts_.begin(), texts_.end(), because);
    if (found != texts_.end())
      return static_cast<std::size_t>(found - texts_.begin()) + 1;
    texts_.push_back(because);
    return texts_.size();
  }

  void Write(std::ostream& out) const {
    if (!texts_.empty()) out << "\nTolerances:\n";
    for (std::size_t i = 0; i < texts_.size(); ++i)
      out << fmt::format("  [{}] {}\n", i + 1, texts_[i]);
  }

 private:
  std::vector<std::string> texts_;
};

/** Returns the law or other reference that a number of a world is compared with. */
std::string HeldAgainst(const Finding& finding) {
  if (!finding.law.empty())
    return finding.universal ? finding.law + ", universal" : finding.law;
  if (finding.measure == MeasureKind::kDeterminism) return std::string(kDeterministic);
  if (finding.measure == MeasureKind::kStability) return std::string(kStable);
  return finding.reference == "law" ? "smaller steps" : "a transformed world";
}

// Writes the numbers of a motion next to their tolerances.
void WriteMotion(const RunReport& report, const WorldResult& world,
                 const Outcome& outcome, const ExplanationStyle& style, Origins& origins,
                 std::ostream& out) {
  const Trajectory& trajectory = world.trajectories[outcome.oracle];
  out << fmt::format("  {:<26} {:<12}", report.oracles[outcome.oracle].name,
                     NameOf(outcome.verdict));
  if (trajectory.status != AnswerStatus::kAnswered) {
    out << OneLine(trajectory.reason) << '\n';
    return;
  }
  const std::string_view model = RecognisedModelOf(outcome);
  const std::string parting = Parting(report, world, outcome.oracle);
  if (!model.empty()) out << "recognised: " << model << (parting.empty() ? "" : "; ");
  out << parting << '\n';
  if (!trajectory.complaint.empty())
    out << "    it printed: " << OneLine(trajectory.complaint) << '\n';
  out << fmt::format("    measured: {}\n",
                     DriftsInWords(world, outcome.oracle, outcome.findings));
  const Finding* largest = nullptr;
  std::size_t within = 0;
  for (const Finding& finding : outcome.findings) {
    if (finding.measure == MeasureKind::kAnswering) continue;
    if (!style.everything && outcome.oracle != 0 && !IsRemarkable(finding)) {
      ++within;
      if (!largest || RelativeToTolerance(finding) > RelativeToTolerance(*largest))
        largest = &finding;
      continue;
    }
    const std::string_view unit = UnitOf(finding.measure);
    const std::string_view recognised = RecognisedModelOf(finding);
    std::string mark(finding.verdict == Verdict::kPass ? "" : NameOf(finding.verdict));
    if (!recognised.empty()) mark = recognised;
    if (finding.shipped != Shipped::kNotAsked)
      mark +=
          fmt::format("{}{}", mark.empty() ? "fails " : ", ", NameOf(finding.shipped));
    out << fmt::format("    {:<24} {:>16} of {:>14}  {:<28} [{}]{}{}\n",
                       NameOf(finding.measure), Quantity(finding.value, unit),
                       Quantity(finding.tolerance, unit), HeldAgainst(finding),
                       origins.NumberOf(finding.tolerance_because),
                       mark.empty() ? "" : " ", mark);
  }
  if (within > 0) {
    out << fmt::format("    {} within their tolerances, at most {} in {}\n",
                       Counted(within, "number"), RelativeInWords(*largest),
                       NameOf(largest->measure));
  }
}

/** Writes the means over the ensemble of a chaotic motion, which are comparable between
 engines. A mean that differs significantly from the subject's is marked. */
void WriteEnsemble(const RunReport& report, const WorldResult& world, std::ostream& out) {
  if (!world.scenario.ensemble) return;
  out << fmt::format(
      "Ensemble of {}, at the end, as mean ± standard error (≠: differs from {} at "
      "significance level 0.001):\n  {:<26}{:>24}{:>24}{:>24}\n",
      world.scenario.ensemble->members, report.subject, "", "kinetic energy [J]",
      "height of centre [m]", "mean width [m]");
  const EnsembleStatistics& subject = world.ensembles.front();
  for (std::size_t o = 0; o < world.ensembles.size(); ++o) {
    const EnsembleStatistics& ensemble = world.ensembles[o];
    if (ensemble.members == 0) continue;
    out << fmt::format("  {:<26}", report.oracles[o].name);
    const auto write = [&](const Statistic& statistic, const Statistic& of_subject) {
      const bool differs = subject.members > 0 && Differ(statistic, ensemble.members,
                                                         of_subject, subject.members);
      out << fmt::format(
          "{:>12.6g} ± {:<8.2g}{}", statistic.mean,
          statistic.deviation / std::sqrt(static_cast<double>(ensemble.members)),
          differs ? "≠" : " ");
    };
    write(ensemble.kinetic_energy, subject.kinetic_energy);
    write(ensemble.height, subject.height);
    write(ensemble.width, subject.width);
    out << '\n';
  }
  out << '\n';
}

void WriteWorld(const RunReport& report, const WorldResult& world,
                std::span<const Outcome> outcomes, const ExplanationStyle& style,
                std::ostream& out) {
  const WorldScenario& scenario = world.scenario;
  out << scenario.id << ": " << scenario.title << '\n';
  if (!scenario.source.empty()) out << "  source: " << OneLine(scenario.source) << '\n';
  out << "  " << Describe(scenario.world) << "\n  laws: " << ClaimsOf(scenario) << "\n\n";
  WriteVerdict(report, outcomes, out);
  out << '\n';
  WriteEnsemble(report, world, out);
  Origins origins;
  for (const Outcome& outcome : outcomes) {
    if (outcome.asked) WriteMotion(report, world, outcome, style, origins, out);
  }
  origins.Write(out);
  out << '\n';
  WriteCharges(report, outcomes, style, out);
}

}  // namespace

void WriteExplanation(const RunReport& report, const ExplanationStyle& style,
                      std::ostream& out) {
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  const std::size_t oracles = report.oracles.size();
  for (std::size_t s = 0; s < report.scenarios.size(); ++s) {
    if (s > 0) out << '\n';
    WriteScenario(report, report.scenarios[s],
                  std::span(outcomes).subspan(s * oracles, oracles), style, out);
  }
  for (std::size_t w = 0; w < report.worlds.size(); ++w) {
    const std::size_t index = report.scenarios.size() + w;
    if (index > 0) out << '\n';
    WriteWorld(report, report.worlds[w],
               std::span(outcomes).subspan(index * oracles, oracles), style, out);
  }
  out << StatedTolerances(report) << WorldSetups(report);
}

void WriteExplanationTable(const RunReport& report, std::ostream& out) {
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  const std::size_t oracles = report.oracles.size();
  std::size_t width = std::string_view("scenario").size();
  for (std::size_t i = 0; i < QuestionCount(report); ++i)
    width = std::max(width, IdOf(report, i).size());
  const auto row = [&](std::string_view id, std::string_view truth,
                       std::string_view separation, std::string_view subject,
                       std::string_view right, std::string_view wrong) {
    out << fmt::format("{:<{}}  {:<11} {:>15}  {:<{}} {:>5}  {}\n", id, width, truth,
                       separation, subject,
                       std::max<std::size_t>(11, report.subject.size()), right, wrong);
  };
  row("scenario", "truth", "separation [m]", report.subject, "right", "wrong");
  for (std::size_t s = 0; s < report.scenarios.size(); ++s) {
    const ScenarioResult& result = report.scenarios[s];
    const auto asked = std::span(outcomes).subspan(s * oracles, oracles);
    const Enclosure& separation = result.truth.separation;
    row(result.scenario.id, NameOf(result.truth.touching),
        fmt::format("{:.9g}", separation.lo + (separation.hi - separation.lo) / 2),
        NameOf(asked.front().verdict),
        fmt::format("{}", std::count_if(asked.begin(), asked.end(), IsRight)),
        Names(report, asked, IsWrong));
  }
  for (std::size_t w = 0; w < report.worlds.size(); ++w) {
    const std::size_t index = report.scenarios.size() + w;
    const auto asked = std::span(outcomes).subspan(index * oracles, oracles);
    const WorldScenario& scenario = report.worlds[w].scenario;
    row(IdOf(report, index),
        Counted(scenario.claims.size() + UniversalClaims(scenario).size(), "law"), "-",
        NameOf(asked.front().verdict),
        fmt::format("{}", std::count_if(asked.begin(), asked.end(), IsRight)),
        Names(report, asked, IsWrong));
  }
  out << StatedTolerances(report) << WorldSetups(report);
}

}  // namespace touchstone
