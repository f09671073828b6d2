#include "reports/worlds/law_support/worst.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace touchstone {
namespace {

auto Gravity(const LawFinding& finding) {
  const bool beyond = !(finding.value <= finding.tolerance.value);
  const double share = finding.value == 0 ? 0 : finding.value / finding.tolerance.value;
  return std::tuple(beyond && finding.recognised.empty(), beyond, share);
}

}  // namespace

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
      } else if (Gravity(finding) > Gravity(*same)) {
        *same = std::move(finding);
      }
    }
  }
  return worst;
}

}  // namespace touchstone
