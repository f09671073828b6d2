#include "cli/commands/choose_fault.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/did_you_mean.h"
#include "cli/input_error.h"
#include "cli/select_oracles.h"
#include "reports/text/counted.h"
#include "reports/writers/outcome.h"

namespace touchstone {
namespace {

Question OnlyQuestion(const ScenarioSelection& selection) {
  const Questions questions = SelectQuestions(selection);
  const std::size_t count = questions.contacts.size() + questions.worlds.size();
  if (count != 1) {
    throw InputError(fmt::format("{} selects {}; expected one",
                                 fmt::join(selection.patterns, " "),
                                 Counted(count, "scenario")));
  }
  if (questions.contacts.empty()) return questions.worlds.front();
  return questions.contacts.front();
}

std::optional<MeasureKind> MeasureOf(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (const auto measure = MeasureNamed(name)) return measure;
  std::vector<std::string_view> names;
  for (const MeasureKind measure : AllMeasures()) names.push_back(NameOf(measure));
  throw InputError(fmt::format("there is no measure '{}'{}; expected one of: {}", name,
                               DidYouMean(name, names), fmt::join(names, ", ")));
}

/** A fault as the options name it. */
struct Wanted {
  std::optional<MeasureKind> measure;
  std::optional<double> over;
};

std::string Trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

Wanted WantedBy(const FaultSelection& selection) {
  if (!selection.keep) return {MeasureOf(selection.measure), std::nullopt};
  const std::string& keep = *selection.keep;
  const std::size_t sign = std::min(keep.find('>'), keep.size());
  const std::string name = Trimmed(keep.substr(0, sign));
  const std::string number = Trimmed(keep.substr(std::min(sign + 1, keep.size())));
  double over = 0;
  const char* const end = number.data() + number.size();
  const auto read = std::from_chars(number.data(), end, over);
  if (name.empty() || read.ec != std::errc() || read.ptr != end || !(over >= 0) ||
      !std::isfinite(over)) {
    throw InputError(fmt::format(
        "--keep '{}': cannot be read; expected a measure and a number that its value "
        "stays over, e.g. 'separation_error > 0.1'",
        keep));
  }
  return {MeasureOf(name), over};
}

std::vector<const Oracle*> OraclesOf(const Session& session, const std::string& pattern) {
  // "bullet" is an oracle and a group: it means the oracle.
  if (const Oracle* const exact = session.registry.Find(pattern)) return {exact};
  if (!pattern.empty()) return OraclesNamed(session.registry, pattern);
  OracleSelection all;
  all.subject = session.default_subject;
  return SelectOracles(session.registry, all);
}

/** Returns the fault of the only oracle of `report`; null if it has none. */
const Finding* FaultIn(const RunReport& report, const Wanted& wanted) {
  if (!wanted.measure) {
    const std::vector<Outcome> outcomes = OutcomesOf(report);
    const Outcome& outcome = outcomes.front();
    return IsFailure(outcome.verdict) ? outcome.decisive : nullptr;
  }
  const auto found = std::find_if(
      report.findings.begin(), report.findings.end(), [&](const Finding& finding) {
        return finding.measure == *wanted.measure && IsFailure(finding.verdict) &&
               !(wanted.over && finding.value <= *wanted.over);
      });
  return found == report.findings.end() ? nullptr : &*found;
}

bool IsIndicted(const ChosenFault& fault) {
  const auto indicts = [&](const Indictment& indictment) {
    return indictment.reproduces && indictment.oracle == fault.oracle->info().name;
  };
  return std::visit(
      [&](const auto& scenario) {
        return std::any_of(scenario.indicts.begin(), scenario.indicts.end(), indicts);
      },
      fault.question);
}

/** The faults of some oracles in one question. */
struct FoundFaults {
  std::vector<ChosenFault> faults;
  std::string reason;  ///< Why the last of them has none.
};

FoundFaults FaultsOf(std::span<const Oracle* const> oracles, const Question& question,
                     const Wanted& wanted) {
  FoundFaults found;
  for (const Oracle* const oracle : oracles) {
    ChosenFault fault{question, oracle, AskAlone(question, *oracle), {}, wanted.over};
    if (const Finding* const finding = FaultIn(fault.report, wanted)) {
      fault.finding = *finding;
      found.faults.push_back(std::move(fault));
    } else {
      found.reason = ReasonOf(fault.report, OutcomesOf(fault.report).front());
    }
  }
  return found;
}

std::vector<std::string_view> NamesOf(std::span<const ChosenFault> faults) {
  std::vector<std::string_view> names;
  names.reserve(faults.size());
  for (const ChosenFault& fault : faults) names.push_back(fault.oracle->info().name);
  return names;
}

/** Throws the error that no oracle of `oracles` has the fault, and says who has it. */
[[noreturn]] void FailWithoutFault(const Session& session,
                                   std::span<const Oracle* const> oracles,
                                   const Question& question, const Wanted& wanted,
                                   const std::string& reason) {
  const bool is_one = oracles.size() == 1;
  std::string expected = "a fault";
  if (is_one) {
    const FoundFaults others = FaultsOf(OraclesOf(session, ""), question, wanted);
    if (!others.faults.empty())
      expected = fmt::format("one of those who are wrong: {}",
                             fmt::join(NamesOf(others.faults), ", "));
  }
  throw InputError(fmt::format(
      "{} is proved wrong{} in {}{}; expected {}",
      is_one ? "no answer of " + oracles.front()->info().name : "no oracle",
      !wanted.measure ? ""
      : !wanted.over
          ? fmt::format(" in {}", NameOf(*wanted.measure))
          : fmt::format(" in {} by more than {}", NameOf(*wanted.measure), *wanted.over),
      IdOf(question), is_one && !reason.empty() ? ": " + reason : "", expected));
}

}  // namespace

ChosenFault ChooseFault(const Session& session, const FaultSelection& selection) {
  const Wanted wanted = WantedBy(selection);
  const std::vector<const Oracle*> oracles = OraclesOf(session, selection.oracle);
  const Question question = OnlyQuestion(selection.scenarios);
  auto [faults, reason] = FaultsOf(oracles, question, wanted);
  if (faults.empty()) FailWithoutFault(session, oracles, question, wanted, reason);
  if (faults.size() > 1) {
    std::stable_partition(faults.begin(), faults.end(), IsIndicted);
    if (!IsIndicted(faults[0]) || IsIndicted(faults[1])) {
      throw InputError(
          fmt::format("{} oracles are wrong in {}; expected --oracle with one of: {}",
                      faults.size(), IdOf(question), fmt::join(NamesOf(faults), ", ")));
    }
  }
  return std::move(faults.front());
}

}  // namespace touchstone
