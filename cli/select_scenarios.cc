#include "cli/select_scenarios.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "reports/ledger/glob.h"
#include "reports/sweep/question_id.h"
#include "reports/text/counted.h"
#include "reports/worlds/study/check_claims.h"
#include "scenarios/scenario_file.h"
#include "scenarios/schema/nearest_name.h"

namespace touchstone {
namespace {

using Ids = std::vector<std::string_view>;

/** The ids of a catalogue, contact queries first. */
Ids IdsOf(const Questions& questions) {
  Ids ids;
  for (const Scenario& scenario : questions.contacts) ids.push_back(scenario.id);
  for (const WorldScenario& scenario : questions.worlds) ids.push_back(scenario.id);
  return ids;
}

bool SelectsAny(std::string_view pattern, const Ids& ids) {
  return std::any_of(ids.begin(), ids.end(),
                     [&](std::string_view id) { return SelectsId(pattern, id); });
}

// A pattern is a path if it cannot be an id (ids have no dots), or if the file exists and
// no known id matches.
bool IsPath(const std::string& pattern, const Ids& known) {
  if (pattern.ends_with(".toml") || pattern.starts_with(".") ||
      pattern.starts_with("/")) {
    return true;
  }
  std::error_code error;  // Set for a name that is too long or a cycle of links.
  return !SelectsAny(pattern, known) && std::filesystem::exists(pattern, error);
}

Questions WithoutErrors(Catalogue catalogue) {
  std::vector<Diagnostic>& errors = catalogue.diagnostics;
  for (const Diagnostic& note : catalogue.notes)
    std::cerr << "touchstone: " << ToNote(note) << '\n';
  for (const WorldScenario& scenario : catalogue.worlds) {
    for (Diagnostic& error : ErrorsOfClaims(scenario)) errors.push_back(std::move(error));
  }
  if (errors.empty())
    return {std::move(catalogue.scenarios), std::move(catalogue.worlds)};
  std::stable_sort(
      errors.begin(), errors.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
      });
  std::string text =
      Counted(errors.size(), "error") + " in scenario files: nothing was run";
  for (const Diagnostic& error : errors) text += fmt::format("\n{}", ToString(error));
  throw InputError(text);
}

// Returns e.g. "contact/sphere_box/*" for "contact/box_sphere/*": a folder names a pair
// of shapes in one order only. Empty if no other order selects anything.
std::string WithShapesInOrder(const std::string& pattern, const Ids& known) {
  for (std::size_t at = 0; (at = pattern.find('_', at)) != std::string::npos; ++at) {
    const std::size_t begin = pattern.rfind('/', at) + 1;  // npos + 1 is 0.
    const std::size_t end = std::min(pattern.find('/', at), pattern.size());
    std::string swapped = pattern.substr(0, begin) +
                          pattern.substr(at + 1, end - at - 1) + '_' +
                          pattern.substr(begin, at - begin) + pattern.substr(end);
    if (SelectsAny(swapped, known)) return swapped;
  }
  return "";
}

// Returns the nearest id or folder of ids; the part with wildcards stays unchanged. Empty
// if none is near.
std::string NearestPattern(const std::string& pattern, const Ids& known) {
  Ids names;
  for (const std::string_view id : known) {
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
  return SelectsAny(suggestion, known) ? suggestion : "";
}

[[noreturn]] void FailOnPattern(const std::string& pattern, const Ids& known) {
  if (pattern.starts_with("sweep/")) {
    throw InputError(fmt::format(
        "no question of a sweep has the id '{}'; expected one such as "
        "sweep/random/box_box/seed_1/42 or sweep/world/drops/seed_1/42, or a file that "
        "`touchstone sweep --out` wrote",
        pattern));
  }
  std::string nearest = WithShapesInOrder(pattern, known);
  if (nearest.empty()) nearest = NearestPattern(pattern, known);
  throw InputError(fmt::format(
      "no scenario matches '{}'{}, and no such file or folder exists; `touchstone list` "
      "shows all ids",
      pattern, nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest)));
}

void RefuseDuplicates(const Questions& questions) {
  Ids ids = IdsOf(questions);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end())
    throw InputError(fmt::format("the scenario id '{}' is used twice", *twice));
}

/** Moves the scenarios of `from` that match one of `patterns` to the end of `to`. */
template <typename Kind>
void MoveSelected(std::vector<Kind>& from, const std::vector<std::string>& patterns,
                  std::vector<Kind>& to) {
  for (Kind& scenario : from) {
    const bool wanted = std::any_of(
        patterns.begin(), patterns.end(),
        [&](const std::string& pattern) { return SelectsId(pattern, scenario.id); });
    if (wanted) to.push_back(std::move(scenario));
  }
}

/** Adds the question of a series of one. */
void Generate(const Series& question, Questions& to) {
  if (const auto* world = std::get_if<WorldSeries>(&question)) {
    to.worlds.push_back(WorldAt(*world, world->first));
  } else {
    const auto& contact = std::get<QuestionSeries>(question);
    to.contacts.push_back(ScenarioAt(contact, contact.first));
  }
}

template <typename Kind>
void Append(std::vector<Kind> from, std::vector<Kind>& to) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
  std::sort(to.begin(), to.end(),
            [](const Kind& a, const Kind& b) { return a.id < b.id; });
}

}  // namespace

bool SelectsId(std::string_view pattern, std::string_view id) {
  while (pattern.ends_with('/')) pattern.remove_suffix(1);
  return MatchesGlob(pattern, id) || MatchesGlob(std::string(pattern) + "/**", id);
}

Questions SelectQuestions(const ScenarioSelection& selection) {
  const auto looks_like_path = [](const std::string& p) { return IsPath(p, {}); };
  const bool only_paths =
      !selection.patterns.empty() &&
      std::all_of(selection.patterns.begin(), selection.patterns.end(), looks_like_path);
  Questions catalogue;
  if (!only_paths) catalogue = WithoutErrors(ReadCatalogue(selection.catalogues));
  if (selection.patterns.empty()) return catalogue;

  std::vector<std::filesystem::path> paths;
  std::vector<std::string> patterns;
  Questions generated;
  const Ids known = IdsOf(catalogue);
  for (const std::string& pattern : selection.patterns) {
    const auto of_sweep = QuestionOfId(pattern);
    if (of_sweep && !SelectsAny(pattern, known)) {
      Generate(*of_sweep, generated);
      continue;
    }
    if (IsPath(pattern, known)) {
      paths.emplace_back(pattern);
      continue;
    }
    if (!SelectsAny(pattern, known)) FailOnPattern(pattern, known);
    patterns.push_back(pattern);
  }
  Questions selected;
  MoveSelected(catalogue.contacts, patterns, selected.contacts);
  MoveSelected(catalogue.worlds, patterns, selected.worlds);
  Append(std::move(generated.contacts), selected.contacts);
  Append(std::move(generated.worlds), selected.worlds);
  if (!paths.empty()) {
    Questions own = WithoutErrors(ReadCatalogue(paths));
    Append(std::move(own.contacts), selected.contacts);
    Append(std::move(own.worlds), selected.worlds);
  }
  RefuseDuplicates(selected);
  return selected;
}

std::set<std::string, std::less<>> OutsideCatalogue(
    const ScenarioSelection& selection, const Questions& questions,
    const std::filesystem::path& catalogue) {
  std::set<std::string, std::less<>> outside;
  const auto may_be_outside = [](const std::string& pattern) {
    return IsPath(pattern, {}) || QuestionOfId(pattern);
  };
  if (selection.catalogues == std::vector{catalogue} &&
      std::ranges::none_of(selection.patterns, may_be_outside))
    return outside;
  const auto known = [&](const std::string& id) {
    return ReadScenarioFile(catalogue / (id + ".toml"));
  };
  for (const Scenario& scenario : questions.contacts) {
    const auto same = known(scenario.id).scenario;
    if (!same || WriteScenario(*same) != WriteScenario(scenario))
      outside.insert(scenario.id);
  }
  for (const WorldScenario& scenario : questions.worlds) {
    const auto same = known(scenario.id).world;
    if (!same || WriteScenario(*same) != WriteScenario(scenario))
      outside.insert(scenario.id);
  }
  return outside;
}

}  // namespace touchstone
