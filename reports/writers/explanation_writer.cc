#include "reports/writers/explanation_writer.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "reports/counted.h"
#include "reports/proof.h"
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

void WriteAnswer(const OracleInfo& oracle, const ContactAnswer& answer,
                 const ContactTruth& truth, Verdict verdict, std::ostream& out) {
  out << fmt::format("  {:<26} {:<12}", oracle.name, NameOf(verdict));
  if (answer.status != AnswerStatus::kAnswered) {
    out << OneLine(answer.reason) << '\n';
    return;
  }
  out << fmt::format(" {:<9}", answer.touching ? "touching" : "apart");
  if (answer.separation) {
    out << fmt::format("{:>20.12g} {:>9.2g} ", *answer.separation,
                       LeastError(*answer.separation, truth));
  } else {
    out << fmt::format("{:>20} {:>9} ", "-", "-");
  }
  out << (answer.n_AB_W ? InWords(*answer.n_AB_W) : "no normal") << '\n';
  for (const ContactPoint& point : answer.points) {
    out << fmt::format("  {:>39} contact {:>20.12g}{:>11}{}\n", "", point.separation, "",
                       InWords(point.p_WC));
  }
}

bool IsRight(const Outcome& outcome) {
  return outcome.verdict == Verdict::kPass;
}

bool IsWrong(const Outcome& outcome) {
  return IsFailure(outcome.verdict) || outcome.verdict == Verdict::kKnown;
}

std::string Names(const RunReport& report, std::span<const Outcome> outcomes,
                  bool (*selects)(const Outcome&)) {
  std::string names;
  for (const Outcome& outcome : outcomes) {
    if (!selects(outcome)) continue;
    names += (names.empty() ? "" : ", ") + report.oracles[outcome.oracle].name;
  }
  return names.empty() ? "nobody" : names;
}

// What an oracle was wrong about, then what the ledger says of it, each reason once.
void WriteFindings(const RunReport& report, const Outcome& outcome, std::ostream& out) {
  std::vector<std::string_view> reasons;
  for (const Finding& finding : outcome.findings) {
    if (finding.verdict == Verdict::kPass || finding.verdict == Verdict::kUnsupported) {
      continue;
    }
    out << "  " << Sentence(finding) << '\n';
    if (!finding.ledger_entry) continue;
    const auto index = static_cast<std::size_t>(*finding.ledger_entry);
    const std::string_view reason = report.ledger.entries[index].reason;
    if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) {
      reasons.push_back(reason);
    }
  }
  for (const std::string_view reason : reasons) {
    out << fmt::format("    Ledger, of {}: {}\n", report.oracles[outcome.oracle].name,
                       reason);
  }
}

void WriteScenario(const RunReport& report, const ScenarioResult& result,
                   std::span<const Outcome> outcomes, std::ostream& out) {
  const Scenario& scenario = result.scenario;
  out << scenario.id << ": " << scenario.title << '\n';
  if (!scenario.source.empty()) out << "  source: " << OneLine(scenario.source) << '\n';
  out << "  A: " << Describe(scenario.contact.A)
      << "\n  B: " << Describe(scenario.contact.B) << "\n\nTruth. "
      << Describe(result.truth) << "\n\n";
  out << fmt::format("  {:<26} {:<12} {:<9}{:>20} {:>9} {}\n", "oracle", "verdict",
                     "says", "separation [m]", "error [m]",
                     "normal A to B; contact point [m]");
  for (std::size_t o = 0; o < outcomes.size(); ++o) {
    WriteAnswer(report.oracles[o], result.answers[o], result.truth, outcomes[o].verdict,
                out);
  }
  out << '\n';
  for (const Outcome& outcome : outcomes) WriteFindings(report, outcome, out);
  out << "\nRight: " << Names(report, outcomes, IsRight)
      << "\nWrong: " << Names(report, outcomes, IsWrong) << '\n';
}

// Every number of a motion beside what its law allows.
void WriteMotion(const RunReport& report, const WorldResult& world,
                 const Outcome& outcome, std::ostream& out) {
  const Trajectory& trajectory = world.trajectories[outcome.oracle];
  out << fmt::format("  {:<26} {:<12}", report.oracles[outcome.oracle].name,
                     NameOf(outcome.verdict));
  if (trajectory.status != AnswerStatus::kAnswered) {
    out << OneLine(trajectory.reason) << '\n';
    return;
  }
  out << Parting(report, world, outcome.oracle) << '\n';
  if (!trajectory.complaint.empty())
    out << "    it printed: " << OneLine(trajectory.complaint) << '\n';
  for (const Finding& finding : outcome.findings) {
    if (finding.measure == MeasureKind::kAnswering) continue;
    const std::string_view unit = UnitOf(finding.measure);
    out << fmt::format("    {:<24} {:>16} of {:>16}  {}\n", NameOf(finding.measure),
                       Quantity(finding.value, unit), Quantity(finding.tolerance, unit),
                       finding.tolerance_because);
  }
}

void WriteWorld(const RunReport& report, const WorldResult& world,
                std::span<const Outcome> outcomes, std::ostream& out) {
  const WorldScenario& scenario = world.scenario;
  out << scenario.id << ": " << scenario.title << '\n';
  if (!scenario.source.empty()) out << "  source: " << OneLine(scenario.source) << '\n';
  out << "  " << Describe(scenario.world) << "\n  laws: " << ClaimsOf(scenario) << "\n\n";
  for (const Outcome& outcome : outcomes) {
    if (outcome.asked) WriteMotion(report, world, outcome, out);
  }
  out << '\n';
  for (const Outcome& outcome : outcomes) WriteFindings(report, outcome, out);
  out << "\nRight: " << Names(report, outcomes, IsRight)
      << "\nWrong: " << Names(report, outcomes, IsWrong) << '\n';
}

}  // namespace

void WriteExplanation(const RunReport& report, std::ostream& out) {
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  const std::size_t oracles = report.oracles.size();
  for (std::size_t s = 0; s < report.scenarios.size(); ++s) {
    if (s > 0) out << '\n';
    WriteScenario(report, report.scenarios[s],
                  std::span(outcomes).subspan(s * oracles, oracles), out);
  }
  for (std::size_t w = 0; w < report.worlds.size(); ++w) {
    const std::size_t index = report.scenarios.size() + w;
    if (index > 0) out << '\n';
    WriteWorld(report, report.worlds[w],
               std::span(outcomes).subspan(index * oracles, oracles), out);
  }
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
    row(IdOf(report, index), Counted(report.worlds[w].scenario.claims.size(), "law"), "-",
        NameOf(asked.front().verdict),
        fmt::format("{}", std::count_if(asked.begin(), asked.end(), IsRight)),
        Names(report, asked, IsWrong));
  }
}

}  // namespace touchstone
