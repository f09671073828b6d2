#include "reports/run_report.h"

#include <algorithm>
#include <span>

#include "reports/finding/grade.h"

namespace touchstone {

double SecondsOf(const RunReport& report, std::size_t oracle, std::size_t i) {
  const std::size_t contacts = report.scenarios.size();
  if (i < contacts) return report.scenarios[i].answers[oracle].seconds;
  const std::vector<WorldSeconds>& seconds = report.worlds[i - contacts].seconds;
  return oracle < seconds.size() ? seconds[oracle].all : 0;
}

std::size_t QuestionCount(const RunReport& report) {
  return report.scenarios.size() + report.worlds.size();
}

const std::string& IdOf(const RunReport& report, std::size_t i) {
  const std::size_t contacts = report.scenarios.size();
  return i < contacts ? report.scenarios[i].scenario.id
                      : report.worlds[i - contacts].scenario.id;
}

const std::string& TitleOf(const RunReport& report, std::size_t i) {
  const std::size_t contacts = report.scenarios.size();
  return i < contacts ? report.scenarios[i].scenario.title
                      : report.worlds[i - contacts].scenario.title;
}

bool Answers(const RunReport& report, std::size_t oracle, std::size_t i) {
  const OracleInfo& info = report.oracles[oracle];
  return i < report.scenarios.size() ? info.AnswersContacts() : info.simulates;
}

std::size_t ImprovedCount(const RunReport& report) {
  return static_cast<std::size_t>(
      std::ranges::count_if(report.faults, [](const std::string& fault) {
        return fault.find(": improved: ") != std::string::npos;
      }));
}

bool IsSubjectExamined(const RunReport& report) {
  const std::span<const Finding> findings = report.findings;
  for (std::size_t begin = 0, end = 0; begin < findings.size(); begin = end) {
    while (end < findings.size() && findings[end].oracle == findings[begin].oracle &&
           findings[end].scenario == findings[begin].scenario) {
      ++end;
    }
    if (findings[begin].oracle == report.subject &&
        IsVerified(findings.subspan(begin, end - begin))) {
      return true;
    }
  }
  return false;
}

bool CountsAsFailure(const Finding& finding, const RunReport& report,
                     const FailureRule& rule) {
  if (!IsFailure(finding.verdict) || !IsGraver(finding.grade, rule.above)) return false;
  if (finding.oracle == report.subject || rule.whose == FailOn::kAnything) return true;
  return rule.whose == FailOn::kFaults && IsGraver(finding.grade, Grade::kRounding);
}

int ExitCode(const RunReport& report, const FailureRule& rule) {
  const auto fails = [&](const Finding& f) { return CountsAsFailure(f, report, rule); };
  const auto subject_fails = [&](const Finding& f) {
    return f.oracle == report.subject && fails(f);
  };
  const auto subject_got_worse = [&](const Regression& r) {
    return r.oracle == report.subject;
  };
  if (std::ranges::any_of(report.findings, subject_fails) ||
      std::ranges::any_of(report.regressions, subject_got_worse))
    return 1;
  if (!IsSubjectExamined(report)) return 2;
  if (!report.faults.empty() || std::ranges::any_of(report.findings, fails)) return 1;
  return rule.whose != FailOn::kSubject && !report.regressions.empty() ? 1 : 0;
}

}  // namespace touchstone
