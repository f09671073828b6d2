#include "reports/writers/explanation_writer.h"

#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/writers/describe.h"
#include "reports/writers/outcome.h"

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
  out << (answer.n_AB_W ? Describe(*answer.n_AB_W) : "no normal") << '\n';
  for (const ContactPoint& point : answer.points) {
    out << fmt::format("  {:>39} contact {:>20.12g}{:>11}{}\n", "", point.separation, "",
                       Describe(point.p_WC));
  }
}

std::string Names(const RunReport& report, std::span<const Outcome> outcomes,
                  bool right) {
  std::string names;
  for (const Outcome& outcome : outcomes) {
    const bool wrong = IsFailure(outcome.verdict) || outcome.verdict == Verdict::kKnown;
    if (right ? outcome.verdict != Verdict::kPass : !wrong) continue;
    names += (names.empty() ? "" : ", ") + report.oracles[outcome.oracle].name;
  }
  return names.empty() ? "nobody" : names;
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
  for (const Outcome& outcome : outcomes) {
    for (const Finding& finding : outcome.findings) {
      if (finding.verdict == Verdict::kPass || finding.verdict == Verdict::kUnsupported) {
        continue;
      }
      out << "  " << Sentence(finding);
      if (finding.ledger_entry) {
        const auto index = static_cast<std::size_t>(*finding.ledger_entry);
        out << " Ledger: " << report.ledger.entries[index].reason;
      }
      out << '\n';
    }
  }
  out << "\nRight: " << Names(report, outcomes, true)
      << "\nWrong: " << Names(report, outcomes, false) << '\n';
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
}

}  // namespace touchstone
