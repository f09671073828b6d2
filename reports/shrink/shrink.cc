#include "reports/shrink/shrink.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "reports/run.h"
#include "reports/shrink/reductions.h"
#include "reports/shrink/same_fault.h"
#include "reports/shrink/shifts.h"
#include "reports/shrink/size.h"

namespace touchstone {
namespace {

/** Removes the expected answer and the indictments, which hold for the original alone. A
 tolerance that the author grants stays: it is part of the judgement. */
void ForgetAnswers(Question& question) {
  std::visit([](auto& scenario) { scenario.indicts.clear(); }, question);
  if (auto* const scenario = std::get_if<Scenario>(&question)) scenario->expect = {};
}

/** Returns the algorithm that `oracle` uses for a contact query; empty for a world. */
std::string FamilyOf(const Question& question, const OracleInfo& oracle) {
  const auto* const scenario = std::get_if<Scenario>(&question);
  if (scenario == nullptr) return "";
  const auto& [A, B] = scenario->contact;
  return oracle.For(KindOf(A.shape), KindOf(B.shape)).family;
}

/** A search in progress. */
class Search {
 public:
  Search(const Question& question, const Oracle& oracle, const Finding& fault,
         const ShrinkOptions& options)
      : oracle_(oracle),
        fault_(fault),
        options_(options),
        family_(FamilyOf(question, oracle.info())),
        result_{
            .question = question, .finding = fault, .over = options.over, .shifts = {}} {
    for (const Finding& finding : AskAlone(question, oracle).findings) {
      if (IsFailure(finding.verdict)) failed_before_.insert(finding.measure);
    }
    ForgetAnswers(result_.question);
    size_ = SizeOf(result_.question);
    result_.shifts = ShiftsWithFault(result_.question, kShifts);
    least_shifts_ = (result_.shifts.value_or(0) + 1) / 2;
  }

  Shrunk Result() && {
    while (TryAll() && !IsOver()) {
    }
    result_.is_smallest = !IsOver();
    if (result_.accepted > 0) result_.shifts = ShiftsWithFault(result_.question, kShifts);
    return std::move(result_);
  }

 private:
  bool IsOver() const { return result_.tried >= options_.tries || IsStopped(); }
  bool IsStopped() const {
    return hangs_ >= options_.hangs || (options_.stop && options_.stop());
  }

  /** Tries every reduction until it yields nothing. Returns whether any did. */
  bool TryAll() {
    const std::size_t before = result_.accepted;
    for (const Reduction& reduction : Reductions()) {
      while (Try(reduction) && !IsOver()) {
      }
    }
    return result_.accepted > before;
  }

  /** Keeps the first candidate of `reduction` that shows the fault. Returns whether there
   is one. */
  bool Try(const Reduction& reduction) {
    bool found = false;
    const Question now = result_.question;
    reduction.propose(now, [&](Question candidate) {
      if (!found && !IsOver()) found = Try(std::move(candidate));
    });
    return found;
  }

  bool Try(Question candidate) {
    const Size size = SizeOf(candidate);
    if (!(size < size_) || !IsValid(candidate)) return false;
    if (FamilyOf(candidate, oracle_.info()) != family_) return false;
    if (!asked_.insert(TextOf(candidate)).second) return false;
    ++result_.tried;
    if (options_.on_try) options_.on_try(result_.tried);
    std::optional<Finding> same = SameFaultOn(candidate);
    if (!same) return false;
    const auto shifts = ShiftsWithFault(candidate, least_shifts_);
    if (shifts && *shifts < least_shifts_) return false;
    ++result_.accepted;
    result_.question = std::move(candidate);
    result_.finding = std::move(*same);
    size_ = size;
    return true;
  }

  /** Returns the finding that shows the fault on `question`, if any does. */
  std::optional<Finding> SameFaultOn(const Question& question) {
    RunReport report = AskAlone(question, oracle_);
    if (std::ranges::any_of(report.findings, [](const Finding& finding) {
          return finding.verdict == Verdict::kTimedOut;
        })) {
      ++hangs_;
    }
    const auto same = std::ranges::find_if(report.findings, [&](const Finding& finding) {
      return IsSameFault(finding, fault_, options_.over);
    });
    if (same == report.findings.end() || ShowsAnother(report)) return std::nullopt;
    return std::move(*same);
  }

  /** Returns whether a contact answer also fails in a measure that is enumerated before
   that of the fault, and did not at first: a contact off the surfaces is another fault
   where there is no contact. */
  bool ShowsAnother(const RunReport& report) const {
    return !report.scenarios.empty() &&
           std::ranges::any_of(report.findings, [&](const Finding& finding) {
             return IsFailure(finding.verdict) && finding.measure < fault_.measure &&
                    !failed_before_.contains(finding.measure);
           });
  }

  /** Returns the number of shifts of `question` that show the fault, counted up to
   `most`; empty for a world or a hang, or if the search is stopped. */
  std::optional<std::size_t> ShiftsWithFault(const Question& question, std::size_t most) {
    const auto* const scenario = std::get_if<Scenario>(&question);
    // Each shift of a hang would take seconds.
    if (scenario == nullptr || fault_.verdict == Verdict::kTimedOut) return std::nullopt;
    std::size_t count = 0;
    for (const Scenario& shifted : ShiftsOf(*scenario)) {
      if (count == most) break;
      if (IsStopped()) return std::nullopt;
      if (IsValid(shifted) && SameFaultOn(shifted)) ++count;
    }
    return count;
  }

  const Oracle& oracle_;
  const Finding& fault_;
  const ShrinkOptions& options_;
  std::string family_;
  Shrunk result_;
  Size size_;
  std::set<MeasureKind> failed_before_;  ///< Those that the original fails.
  std::size_t hangs_ = 0;                ///< Answers that timed out.
  std::size_t least_shifts_ = 0;  ///< That an accepted candidate shows the fault in.
  std::set<std::string> asked_;   ///< Texts of the candidates that were asked.
};

}  // namespace

RunReport AskAlone(const Question& question, const Oracle& oracle) {
  Questions questions;
  if (const auto* const scenario = std::get_if<Scenario>(&question)) {
    questions.contacts.push_back(*scenario);
  } else {
    questions.worlds.push_back(std::get<WorldScenario>(question));
  }
  RunOptions options;
  options.jobs = 1;
  options.partial = true;
  const Oracle* const alone = &oracle;
  return Run(questions, {&alone, 1}, {}, options);
}

Shrunk Shrink(const Question& question, const Oracle& oracle, const Finding& fault,
              const ShrinkOptions& options) {
  return Search(question, oracle, fault, options).Result();
}

}  // namespace touchstone
