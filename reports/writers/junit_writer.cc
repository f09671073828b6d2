#include "reports/writers/junit_writer.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/writers/outcome.h"
#include "reports/writers/xml_text.h"

namespace touchstone {
namespace {

struct SuiteCounts {
  int tests = 0;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
  double seconds = 0;

  void Add(Verdict verdict, bool counts, double took) {
    ++tests;
    seconds += took;
    const bool is_skipped = verdict == Verdict::kKnown ||
                            verdict == Verdict::kUnsupported ||
                            (IsFailure(verdict) && !counts);
    if (is_skipped) {
      ++skipped;
    } else if (verdict == Verdict::kCrashed || verdict == Verdict::kTimedOut) {
      ++errors;
    } else if (IsFailure(verdict)) {
      ++failures;
    }
  }

  std::string Attributes() const {
    return fmt::format(
        R"(tests="{}" failures="{}" errors="{}" skipped="{}" time="{:.6f}")", tests,
        failures, errors, skipped, seconds);
  }
};

std::string Message(const RunReport& report, const Outcome& outcome) {
  if (outcome.verdict == Verdict::kUnsupported) {
    const std::string_view reason = ReasonOf(report, outcome);
    return std::string(reason.empty() ? "unsupported" : reason);
  }
  const Finding& finding = *outcome.decisive;
  if (outcome.verdict == Verdict::kKnown && finding.ledger_entry) {
    const auto entry = static_cast<std::size_t>(*finding.ledger_entry);
    const std::string& reason = report.ledger.entries[entry].reason;
    if (finding.shipped == Shipped::kNotAsked) return reason;
    return fmt::format("{} ({}: {})", reason, NameOf(finding.shipped),
                       finding.shipped_because);
  }
  return Sentence(finding);
}

std::string AllSentences(const Outcome& outcome) {
  std::string text;
  for (const Finding& finding : outcome.findings) {
    if (finding.verdict != Verdict::kPass) text += Sentence(finding) + "\n";
  }
  return text;
}

void WriteCase(const RunReport& report, const Outcome& outcome, bool counts,
               std::ostream& out) {
  out << fmt::format(R"(    <testcase classname="{}" name="{}" time="{:.6f}")",
                     XmlText(report.oracles[outcome.oracle].name),
                     XmlText(IdOf(report, outcome.scenario)),
                     SecondsOf(report, outcome.oracle, outcome.scenario));
  if (outcome.verdict == Verdict::kPass) {
    out << "/>\n";
    return;
  }
  const std::string type = XmlText(NameOf(outcome.verdict));
  const std::string message = XmlText(Message(report, outcome));
  const std::string details = XmlText(AllSentences(outcome));
  out << ">\n";
  if (outcome.verdict == Verdict::kUndecidable) {
    out << fmt::format("      <system-out>{}</system-out>\n", details);
  } else if (outcome.verdict == Verdict::kKnown ||
             outcome.verdict == Verdict::kUnsupported || !counts) {
    out << fmt::format("      <skipped type=\"{}\" message=\"{}\"/>\n", type, message);
  } else {
    const char* element =
        outcome.verdict == Verdict::kCrashed || outcome.verdict == Verdict::kTimedOut
            ? "error"
            : "failure";
    out << fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", element,
                       type, message, details);
  }
  out << "    </testcase>\n";
}

}  // namespace

void WriteJUnit(const RunReport& report, const FailureRule& rule, std::ostream& out) {
  const auto counts = [&](const Outcome& outcome) {
    return CountsAsFailure(outcome, report, rule);
  };
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  std::vector<SuiteCounts> suites(report.oracles.size());
  SuiteCounts total;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.asked) continue;
    const double seconds = SecondsOf(report, outcome.oracle, outcome.scenario);
    suites[outcome.oracle].Add(outcome.verdict, counts(outcome), seconds);
    total.Add(outcome.verdict, counts(outcome), seconds);
  }
  const int faults = static_cast<int>(report.faults.size());
  total.tests += faults;
  total.failures += faults;

  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out << fmt::format("<testsuites name=\"touchstone\" {}>\n", total.Attributes());
  for (std::size_t o = 0; o < report.oracles.size(); ++o) {
    const OracleInfo& oracle = report.oracles[o];
    out << fmt::format("  <testsuite name=\"{}\" {}>\n", XmlText(oracle.name),
                       suites[o].Attributes());
    out << fmt::format(
        "    <properties>\n"
        "      <property name=\"library\" value=\"{} {}\"/>\n"
        "      <property name=\"role\" value=\"{}\"/>\n"
        "    </properties>\n",
        XmlText(oracle.library), XmlText(oracle.version),
        o == 0 ? "subject" : "reference");
    for (std::size_t s = 0; s < QuestionCount(report); ++s) {
      const Outcome& outcome = outcomes[s * report.oracles.size() + o];
      if (outcome.asked) WriteCase(report, outcome, counts(outcome), out);
    }
    out << "  </testsuite>\n";
  }
  if (faults > 0) {
    out << fmt::format(
        "  <testsuite name=\"catalogue and ledger\" tests=\"{0}\" failures=\"{0}\" "
        "errors=\"0\" skipped=\"0\">\n",
        faults);
    for (int i = 0; i < faults; ++i) {
      const std::string text = XmlText(report.faults[static_cast<std::size_t>(i)]);
      out << fmt::format(
          "    <testcase classname=\"catalogue and ledger\" name=\"fault {}\">\n"
          "      <failure type=\"fault\" message=\"{}\"/>\n"
          "    </testcase>\n",
          i + 1, text);
    }
    out << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
}

}  // namespace touchstone
