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

/** The id that a file states, and where. */
struct StatedId {
  std::string id;
  int line;
  int column;
};

/** A scenario, or everything that is wrong with its file. Without diagnostics there is
 one of the two, with any there is none. */
struct ReadResult {
  std::optional<Scenario> scenario;    ///< Where the file has [contact].
  std::optional<WorldScenario> world;  ///< Where the file has [world].
  std::vector<Diagnostic>
      diagnostics;                    ///< Every error of the file, in the order of lines.
  std::optional<StatedId> stated_id;  ///< Present even where the rest is wrong.
};

/** Reads a scenario from TOML; `file_name` is what diagnostics call it. */
ReadResult ReadScenario(std::string_view text, std::string_view file_name);

/** Reads one scenario file, wherever it lies and whatever its id. */
ReadResult ReadScenarioFile(const std::filesystem::path& file);

/** The scenarios of some files and folders, with everything that is wrong with them. */
struct Catalogue {
  std::vector<Scenario> scenarios;      ///< Those without errors, sorted by id.
  std::vector<WorldScenario> worlds;    ///< Likewise.
  std::vector<Diagnostic> diagnostics;  ///< Of every file, sorted by file and line.
};

/** Reads files, and folders with all `.toml` files below them.

 Beyond the errors of each file: an id used twice, in whichever files and for
 whichever question; in a folder, an id that is not the file's path below the catalogue's
 root (the folder given, or one above it, so that a part of a catalogue can be read
 alone); a path that cannot be read; a folder without a scenario. */
Catalogue ReadCatalogue(std::span<const std::filesystem::path> files_and_folders);
Catalogue ReadCatalogue(const std::filesystem::path& file_or_folder);

/** Returns the file that reads back as `scenario`, bit for bit: numbers are the shortest
 decimals that do.
 @pre FaultsOf(scenario) is empty (scenarios/validate_scenario.h), and its strings are
 UTF-8. */
std::string WriteScenario(const Scenario& scenario);

/** Likewise for a world. @pre FaultsOf(scenario) is empty
 (scenarios/worlds/validate_world.h), and its strings are UTF-8. */
std::string WriteScenario(const WorldScenario& scenario);

}  // namespace touchstone
