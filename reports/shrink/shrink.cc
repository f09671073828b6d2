#include "reports/shrink/shrink.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "reports/run.h"
#include "reports/shrink/reductions.h"
#include "reports/shrink/same_fault.h"
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
        result_{question, fault} {
    ForgetAnswers(result_.question);
    size_ = SizeOf(result_.question);
  }

  Shrunk Result() && {
    while (TryAll() && !IsOver()) {
    }
    result_.is_smallest = !IsOver();
    return std::move(result_);
  }

 private:
  bool IsOver() const {
    return result_.tried >= options_.tries || (options_.stop && options_.stop());
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
    const RunReport report = AskAlone(candidate, oracle_);
    const auto same = std::find_if(
        report.findings.begin(), report.findings.end(),
        [&](const Finding& finding) { return IsSameFault(finding, fault_); });
    if (same == report.findings.end()) return false;
    ++result_.accepted;
    result_.question = std::move(candidate);
    result_.finding = *same;
    size_ = size;
    return true;
  }

  const Oracle& oracle_;
  const Finding& fault_;
  const ShrinkOptions& options_;
  std::string family_;
  Shrunk result_;
  Size size_;
  std::set<std::string> asked_;  ///< Texts of the candidates that were asked.
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
