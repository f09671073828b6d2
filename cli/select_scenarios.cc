#include "cli/select_scenarios.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "reports/glob.h"
#include "scenarios/scenario_file.h"
#include "scenarios/schema/nearest_name.h"

namespace touchstone {
namespace {

// A path is what no id can be (ids have no dots), or what is there and is no known id.
bool IsPath(const std::string& pattern, const std::vector<Scenario>& catalogue) {
  if (pattern.ends_with(".toml") || pattern.starts_with(".") ||
      pattern.starts_with("/")) {
    return true;
  }
  const bool is_id =
      std::any_of(catalogue.begin(), catalogue.end(),
                  [&](const Scenario& s) { return SelectsId(pattern, s.id); });
  return !is_id && std::filesystem::exists(pattern);
}

std::vector<Scenario> WithoutErrors(Catalogue catalogue) {
  if (catalogue.diagnostics.empty()) return std::move(catalogue.scenarios);
  std::string text;
  for (const Diagnostic& diagnostic : catalogue.diagnostics) {
    text += ToString(diagnostic) + "\n";
  }
  throw InputError(text + fmt::format("{} errors in scenario files: nothing was run",
                                      catalogue.diagnostics.size()));
}

[[noreturn]] void FailOnPattern(const std::string& pattern,
                                const std::vector<Scenario>& catalogue) {
  std::vector<std::string_view> ids;
  for (const Scenario& scenario : catalogue) ids.push_back(scenario.id);
  const std::string_view nearest = NearestName(pattern, ids);
  throw InputError(fmt::format(
      "no scenario matches '{}'{}, and no such file or folder is there; `touchstone "
      "list` "
      "shows the {} ids",
      pattern, nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest),
      ids.size()));
}

void RefuseDuplicates(const std::vector<Scenario>& scenarios) {
  for (std::size_t i = 1; i < scenarios.size(); ++i) {
    if (scenarios[i - 1].id == scenarios[i].id) {
      throw InputError(
          fmt::format("the scenario id '{}' is used twice", scenarios[i].id));
    }
  }
}

}  // namespace

bool SelectsId(std::string_view pattern, std::string_view id) {
  while (pattern.ends_with('/')) pattern.remove_suffix(1);
  return MatchesGlob(pattern, id) || MatchesGlob(std::string(pattern) + "/**", id);
}

std::vector<Scenario> SelectScenarios(const ScenarioSelection& selection) {
  const auto looks_like_path = [](const std::string& p) { return IsPath(p, {}); };
  const bool only_paths =
      !selection.patterns.empty() &&
      std::all_of(selection.patterns.begin(), selection.patterns.end(), looks_like_path);
  std::vector<Scenario> catalogue;
  if (!only_paths) catalogue = WithoutErrors(ReadCatalogue(selection.catalogues));
  if (selection.patterns.empty()) return catalogue;

  std::vector<std::filesystem::path> paths;
  std::vector<bool> selected(catalogue.size(), false);
  for (const std::string& pattern : selection.patterns) {
    if (IsPath(pattern, catalogue)) {
      paths.emplace_back(pattern);
      continue;
    }
    bool found = false;
    for (std::size_t i = 0; i < catalogue.size(); ++i) {
      if (!SelectsId(pattern, catalogue[i].id)) continue;
      selected[i] = true;
      found = true;
    }
    if (!found) FailOnPattern(pattern, catalogue);
  }
  std::vector<Scenario> scenarios;
  for (std::size_t i = 0; i < catalogue.size(); ++i) {
    if (selected[i]) scenarios.push_back(std::move(catalogue[i]));
  }
  if (!paths.empty()) {
    std::vector<Scenario> own = WithoutErrors(ReadCatalogue(paths));
    std::move(own.begin(), own.end(), std::back_inserter(scenarios));
  }
  std::sort(scenarios.begin(), scenarios.end(),
            [](const Scenario& a, const Scenario& b) { return a.id < b.id; });
  RefuseDuplicates(scenarios);
  return scenarios;
}

}  // namespace touchstone
