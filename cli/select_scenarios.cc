#include "cli/select_scenarios.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "reports/counted.h"
#include "reports/glob.h"
#include "scenarios/scenario_file.h"
#include "scenarios/schema/nearest_name.h"

namespace touchstone {
namespace {

bool SelectsAny(std::string_view pattern, const std::vector<Scenario>& catalogue) {
  return std::any_of(catalogue.begin(), catalogue.end(),
                     [&](const Scenario& s) { return SelectsId(pattern, s.id); });
}

// A path is what no id can be (ids have no dots), or what is there and is no known id.
bool IsPath(const std::string& pattern, const std::vector<Scenario>& catalogue) {
  if (pattern.ends_with(".toml") || pattern.starts_with(".") ||
      pattern.starts_with("/")) {
    return true;
  }
  return !SelectsAny(pattern, catalogue) && std::filesystem::exists(pattern);
}

std::vector<Scenario> WithoutErrors(Catalogue catalogue) {
  if (catalogue.diagnostics.empty()) return std::move(catalogue.scenarios);
  std::string text;
  for (const Diagnostic& diagnostic : catalogue.diagnostics) {
    text += ToString(diagnostic) + "\n";
  }
  throw InputError(text + Counted(catalogue.diagnostics.size(), "error") +
                   " in scenario files: nothing was run");
}

// "contact/sphere_box/*" of "contact/box_sphere/*": a folder names a pair of shapes in
// one order only. Empty where no other order selects anything.
std::string WithShapesInOrder(const std::string& pattern,
                              const std::vector<Scenario>& catalogue) {
  for (std::size_t at = 0; (at = pattern.find('_', at)) != std::string::npos; ++at) {
    const std::size_t begin = pattern.rfind('/', at) + 1;  // npos + 1 is 0.
    const std::size_t end = std::min(pattern.find('/', at), pattern.size());
    const std::string swapped = pattern.substr(0, begin) +
                                pattern.substr(at + 1, end - at - 1) + '_' +
                                pattern.substr(begin, at - begin) + pattern.substr(end);
    if (SelectsAny(swapped, catalogue)) return swapped;
  }
  return "";
}

// The nearest id or folder of ids, with the part that has wildcards left as it is. Empty
// where none is near.
std::string NearestPattern(const std::string& pattern,
                           const std::vector<Scenario>& catalogue) {
  std::vector<std::string_view> names;
  for (const Scenario& scenario : catalogue) {
    const std::string_view id = scenario.id;
    names.push_back(id);
    for (std::size_t at = 0; (at = id.find('/', at)) != std::string_view::npos; ++at) {
      names.push_back(id.substr(0, at));
    }
  }
  const std::size_t wildcard = pattern.find('*');
  const std::size_t literal =
      wildcard == std::string::npos ? pattern.size() : pattern.rfind('/', wildcard);
  if (literal == std::string::npos) return "";
  const std::string_view nearest = NearestName(pattern.substr(0, literal), names);
  const std::string suggestion = std::string(nearest) + pattern.substr(literal);
  return SelectsAny(suggestion, catalogue) ? suggestion : "";
}

[[noreturn]] void FailOnPattern(const std::string& pattern,
                                const std::vector<Scenario>& catalogue) {
  std::string nearest = WithShapesInOrder(pattern, catalogue);
  if (nearest.empty()) nearest = NearestPattern(pattern, catalogue);
  throw InputError(fmt::format(
      "no scenario matches '{}'{}, and no such file or folder is there; `touchstone "
      "list` shows all ids",
      pattern, nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest)));
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
