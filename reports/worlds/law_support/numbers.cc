#include "reports/worlds/law_support/numbers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace touchstone {

std::vector<Fault> FaultsOfNumbers(
    const Claim& claim, const std::vector<std::pair<std::string_view, double>>& truths) {
  std::vector<Fault> faults;
  for (const auto& [name, value] : claim.numbers) {
    const std::string where = "numbers." + name;
    if (!std::isfinite(value)) {
      faults.push_back({where, fmt::format("is {}", value), "a finite number"});
      continue;
    }
    const auto truth =
        std::find_if(truths.begin(), truths.end(),
                     [&name = name](const auto& t) { return t.first == name; });
    if (truth != truths.end()) {
      // Written so that a NaN truth contradicts.
      if (!(std::abs(value - truth->second) <= kNumberSlack * std::abs(truth->second))) {
        faults.push_back({where, fmt::format("is {:.9g}", value),
                          fmt::format("{:.9g}, which {} derives from the world",
                                      truth->second, claim.law)});
      }
      continue;
    }
    // Law::numbers lists the other numbers that the law knows.
    if (!name.starts_with("expected_")) continue;
    std::vector<std::string_view> derived;
    for (const auto& [derived_name, unused] : truths) derived.push_back(derived_name);
    faults.push_back(
        {where, fmt::format("is no number that {} derives for this world", claim.law),
         derived.empty() ? std::string("no such number")
                         : fmt::format("one of {}", fmt::join(derived, ", "))});
  }
  return faults;
}

std::vector<Fault> Joined(std::vector<Fault> faults, std::vector<Fault> more) {
  for (Fault& fault : more) faults.push_back(std::move(fault));
  return faults;
}

double NumberOr(const Claim& claim, std::string_view name, double absent) {
  const auto found = claim.numbers.find(std::string(name));
  return found == claim.numbers.end() ? absent : found->second;
}

}  // namespace touchstone
