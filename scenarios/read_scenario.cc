#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "scenarios/scenario_file.h"
#include "scenarios/schema/scenario_keys.h"
#include "scenarios/toml/check_nesting.h"
#include "scenarios/toml/check_structure.h"
#include "scenarios/toml/places_from.h"
#include "scenarios/toml/read_contact.h"
#include "scenarios/toml/read_world.h"
#include "scenarios/validate_scenario.h"

namespace touchstone {
namespace {

/** Returns the kind of `file`: a world if it has [world], or if it has no [contact] but a
 table that only worlds have; else a contact query. */
TableKind KindOf(const toml::table& file) {
  const std::span<const std::string_view> of_worlds = KeysOfWorldsOnly();
  const bool is_world =
      file.contains("world") ||
      (!file.contains("contact") &&
       std::any_of(of_worlds.begin(), of_worlds.end(),
                   [&file](std::string_view key) { return file.contains(key); }));
  return is_world ? TableKind::kWorldFile : TableKind::kContactFile;
}

void Read(const toml::table& file, std::string_view file_name, FileLog& log,
          ReadResult& result) {
  const TableKind kind = KindOf(file);
  CheckStructure(file, kind, log);
  if (kind == TableKind::kWorldFile) {
    result.world = WorldFrom(file, std::filesystem::path(file_name).parent_path(), log);
    result.world->places = PlacesFrom(file, file_name);
  } else {
    result.scenario = ContactFrom(file, log);
    result.scenario->places = PlacesFrom(file, file_name);
  }
  const toml::node* id = file.get("id");
  const std::string text = file["id"].value_or(std::string());
  if (IsScenarioId(text)) {
    result.stated_id = {text, static_cast<int>(id->source().begin.line),
                        static_cast<int>(id->source().begin.column)};
  }
}

}  // namespace

ReadResult ReadScenario(std::string_view text, std::string_view file_name) {
  FileLog log(file_name);
  ReadResult result;
  try {
    if (CheckNesting(text, log))
      Read(toml::parse(text, file_name), file_name, log, result);
  } catch (const toml::parse_error& error) {
    log.Add(error.source(), std::string(error.description()), "valid TOML 1.0");
  }
  result.notes = log.notes();
  result.diagnostics = std::move(log).InOrderOfLines();
  if (!result.diagnostics.empty()) {
    result.scenario.reset();
    result.world.reset();
  }
  return result;
}

}  // namespace touchstone
