#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/diagnostic.h"
#include "scenarios/scenario.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The id that a file states, and its position. */
struct StatedId {
  std::string id;
  int line;
  int column;
};

/** The result of reading a file: a scenario or a list of errors. Without diagnostics,
 exactly one of `scenario` and `world` is set; with any, neither is. */
struct ReadResult {
  std::optional<Scenario> scenario;     ///< Set if the file has [contact].
  std::optional<WorldScenario> world;   ///< Set if the file has [world].
  std::vector<Diagnostic> diagnostics;  ///< Every error in the file, sorted by line.
  /** Changes that made a value usable; these are not errors. */
  std::vector<Diagnostic> notes;
  std::optional<StatedId> stated_id;  ///< Set even if the rest of the file is wrong.
};

/** Reads a scenario from TOML; `file_name` is the name used in diagnostics. */
ReadResult ReadScenario(std::string_view text, std::string_view file_name);

/** Reads one scenario file; its id need not match its path. */
ReadResult ReadScenarioFile(const std::filesystem::path& file);

/** The scenarios of a set of files and folders, with all errors found in them. */
struct Catalogue {
  std::vector<Scenario> scenarios;      ///< Scenarios without errors, sorted by id.
  std::vector<WorldScenario> worlds;    ///< Worlds without errors, sorted by id.
  std::vector<Diagnostic> diagnostics;  ///< All errors, sorted by file and line.
  std::vector<Diagnostic> notes;        ///< ReadResult::notes of all files.
};

/** Reads files, and folders with all `.toml` files below them.

 In addition to the errors of each file, it reports:
 - an id used twice, across all files and both kinds of question;
 - in a folder, an id that is not the file's path below the catalogue's root (the given
   folder or one of its parents, so that part of a catalogue can be read alone);
 - a path that cannot be read;
 - a folder without a scenario. */
Catalogue ReadCatalogue(std::span<const std::filesystem::path> files_and_folders);
Catalogue ReadCatalogue(const std::filesystem::path& file_or_folder);

/** Returns the text of a file that reads back as `scenario` bit for bit. Each number is
 the shortest decimal with that property.
 @pre FaultsOf(scenario) is empty (scenarios/validate_scenario.h), and its strings are
 UTF-8. */
std::string WriteScenario(const Scenario& scenario);

/** Likewise for a world. @pre FaultsOf(scenario) is empty
 (scenarios/worlds/validate_world.h), and its strings are UTF-8. */
std::string WriteScenario(const WorldScenario& scenario);

}  // namespace touchstone
