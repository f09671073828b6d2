#include "reports/bench/growth.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchstone {
namespace {

/** Least number of bodies for the overall exponent: below it, the fixed cost of a step
 hides the growth. */
constexpr int kMany = 1000;

using Sizes = std::pair<int, int>;  // Smaller, larger.

// fmt would take its thousands separators from the locale.
std::string WithCommas(int number) {
  if (number < 1000) return std::to_string(number);
  return WithCommas(number / 1000) + fmt::format(",{:03}", number % 1000);
}

std::vector<Sizes> Columns(std::span<const TimeOfSize> times) {
  std::set<int> sizes;
  for (const TimeOfSize& time : times) sizes.insert(time.bodies);
  std::vector<Sizes> columns;
  for (auto size = sizes.begin(); size != sizes.end(); ++size) {
    if (size != sizes.begin()) columns.emplace_back(*std::prev(size), *size);
  }
  const auto least = sizes.lower_bound(kMany);
  if (least != sizes.end() && std::distance(least, sizes.end()) > 2) {
    columns.emplace_back(*least, *sizes.rbegin());
  }
  return columns;
}

std::optional<double> Exponent(std::span<const TimeOfSize> times, std::string_view oracle,
                               const Sizes& sizes) {
  const auto at = [&](int bodies) {
    return std::find_if(times.begin(), times.end(), [&](const TimeOfSize& time) {
      return time.oracle == oracle && time.bodies == bodies;
    });
  };
  const auto less = at(sizes.first);
  const auto greater = at(sizes.second);
  if (less == times.end() || greater == times.end()) return std::nullopt;
  return GrowthExponent(*less, *greater);
}

// Names of the oracles, in the order of their first appearance.
std::vector<std::string_view> Oracles(std::span<const TimeOfSize> times) {
  std::vector<std::string_view> oracles;
  for (const TimeOfSize& time : times) {
    if (std::find(oracles.begin(), oracles.end(), time.oracle) == oracles.end())
      oracles.emplace_back(time.oracle);
  }
  return oracles;
}

}  // namespace

double GrowthExponent(const TimeOfSize& a, const TimeOfSize& b) {
  return std::log(b.microseconds / a.microseconds) /
         std::log(static_cast<double>(b.bodies) / a.bodies);
}

std::string GrowthTable(std::string_view bodies, std::span<const TimeOfSize> times) {
  const std::vector<Sizes> columns = Columns(times);
  std::string table = fmt::format("growth of µs/step with the number n of {}\n  {:<24}",
                                  bodies, "oracle");
  for (const auto& [less, greater] : columns) {
    table += fmt::format("{:>18}",
                         fmt::format("{} to {}", WithCommas(less), WithCommas(greater)));
  }
  table += '\n';
  bool any = false;
  for (const std::string_view oracle : Oracles(times)) {
    std::string row = fmt::format("  {:<24}", oracle);
    bool measured = false;
    for (const Sizes& sizes : columns) {
      const std::optional<double> exponent = Exponent(times, oracle, sizes);
      row += fmt::format("{:>18}", exponent ? fmt::format("n^{:.2f}", *exponent) : "-");
      measured = measured || exponent.has_value();
    }
    if (measured) table += row + '\n';
    any = any || measured;
  }
  return any ? table : "";
}

}  // namespace touchstone
