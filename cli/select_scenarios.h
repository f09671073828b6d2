#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run_report.h"

namespace touchstone {

/** Which scenarios a command is about. */
struct ScenarioSelection {
  /** Scenario ids, prefixes of ids at a '/', globs ('*' within a level, '**' across
   levels), or TOML files and folders of them. Empty: the whole catalogue. */
  std::vector<std::string> patterns;
  std::vector<std::filesystem::path> catalogues;  ///< Where ids are looked up.
};

/** Returns whether `pattern` selects the scenario `id`: the id itself, a folder of it, or
 a glob that matches either. */
bool SelectsId(std::string_view pattern, std::string_view id);

/** Returns the selected questions, each kind sorted by id. Throws InputError where a
 pattern selects nothing (naming the nearest id), or where a file has errors (naming all
 of them: nothing of a broken selection is used). */
Questions SelectQuestions(const ScenarioSelection& selection);

/** Returns the ids of those `questions` that are not of the catalogue in the folder
 `catalogue`, selected from it by `selection`: it has no file of that id, or one that says
 something else. */
std::set<std::string, std::less<>> Strangers(const ScenarioSelection& selection,
                                             const Questions& questions,
                                             const std::filesystem::path& catalogue);

}  // namespace touchstone
