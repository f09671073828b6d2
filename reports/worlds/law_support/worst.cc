#include "reports/worlds/law_support/worst.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace touchstone {
namespace {

auto RankOf(const LawFinding& finding) {
  const bool beyond = IsBeyond(finding);
  return std::tuple(beyond && finding.recognised.empty(), beyond,
                    std::isnan(finding.value),
                    InTolerances(finding.value, finding.tolerance.value));
}

std::optional<double> Earlier(const std::optional<double>& a,
                              const std::optional<double>& b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}

}  // namespace

LawFinding Worst::RecognisedAs(std::string_view model) const {
  LawFinding finding = finding_;
  if (IsBeyond()) finding.recognised = model;
  return finding;
}

bool AnyBeyond(const std::vector<Worst>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Worst& worst) { return worst.IsBeyond(); });
}

std::vector<LawFinding> FindingsOf(const std::vector<Worst>& findings,
                                   std::string_view model) {
  std::vector<LawFinding> taken;
  for (const Worst& worst : findings) {
    if (worst.IsTaken()) taken.push_back(worst.RecognisedAs(model));
  }
  return taken;
}

std::vector<LawFinding> WorstOfEach(
    const std::vector<int>& subjects,
    const std::function<std::vector<LawFinding>(int subject)>& judge) {
  std::vector<LawFinding> worst;
  for (const int subject : subjects) {
    for (LawFinding& finding : judge(subject)) {
      const auto same = std::find_if(
          worst.begin(), worst.end(),
          [&](const LawFinding& other) { return other.measure == finding.measure; });
      if (same == worst.end()) {
        worst.push_back(std::move(finding));
        continue;
      }
      const std::optional<double> first =
          Earlier(same->cited.first_time, finding.cited.first_time);
      const Within largest =
          std::ranges::max(same->largest, finding.largest, {}, &Within::value);
      if (RankOf(finding) > RankOf(*same)) *same = std::move(finding);
      same->largest = largest;
      same->cited.first_time = first;
    }
  }
  return worst;
}

}  // namespace touchstone
