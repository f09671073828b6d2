#include "reports/worlds/study/deciding_defaults.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace touchstone {

DecidingDefaults::DecidingDefaults(const Oracle& oracle, Judge judge)
    : oracle_(oracle), judge_(std::move(judge)) {
  const OracleInfo& info = oracle.info();
  const std::vector<double> values = ValuesOf(info.parameters, info.setup);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != info.parameters[i].shipped)
      differences_.push_back({&info.parameters[i], values[i]});
  }
}

const std::vector<Finding>& DecidingDefaults::FindingsWith(const Choice& defaults) {
  const auto found = asked_.find(defaults);
  if (found != asked_.end()) return found->second;
  WorldSetup setup = oracle_.info().setup;
  for (std::size_t i = 0; i < defaults.size(); ++i) {
    const WorldParameter& parameter = *differences_[i].parameter;
    if (defaults[i]) setup.chosen[parameter.name] = parameter.shipped;
  }
  const std::unique_ptr<Oracle> changed = oracle_.SetUp(setup);
  return asked_.emplace(defaults, judge_(*changed)).first->second;
}

std::string DecidingDefaults::InWords(const Choice& defaults) const {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < defaults.size(); ++i) {
    const auto& [parameter, value] = differences_[i];
    if (defaults[i])
      words.push_back(
          fmt::format("{} = {}, {} here", parameter->name, parameter->shipped, value));
  }
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string DecidingDefaults::Name(const IsAsShipped& is_as_shipped, bool together) {
  if (empty()) return "";
  const Choice none(differences_.size(), false);
  std::vector<std::string> alone;
  for (std::size_t i = 0; i < none.size(); ++i) {
    Choice one = none;
    one[i] = true;
    if (is_as_shipped(FindingsWith(one))) alone.push_back(InWords(one));
  }
  if (!alone.empty())
    return fmt::format("; the default {}, is enough", fmt::join(alone, "; or "));
  Choice needed(none.size(), true);
  const std::string all = InWords(needed);
  if (!together) return fmt::format("; no default alone is enough, of {}", all);
  for (std::size_t i = 0; i < needed.size(); ++i) {
    needed[i] = false;
    // A single default was not enough, so at least two are needed.
    if (std::count(needed.begin(), needed.end(), true) < 2 ||
        !is_as_shipped(FindingsWith(needed)))
      needed[i] = true;
  }
  return fmt::format("; no default alone is enough, but together {}", InWords(needed));
}

}  // namespace touchstone
