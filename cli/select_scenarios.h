#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run.h"

namespace touchstone {

/** The scenarios that a command uses. */
struct ScenarioSelection {
  /** Scenario ids, prefixes of ids at a '/', globs ('*' within a level, '**' across
   levels), ids of a sweep's questions, or TOML files and folders of them. Empty: the
   whole catalogue. */
  std::vector<std::string> patterns;
  std::vector<std::filesystem::path> catalogues;  ///< Folders in which ids are looked up.
};

/** Returns whether `pattern` selects the scenario `id`: the id itself, a folder of it, or
 a glob that matches either. */
bool SelectsId(std::string_view pattern, std::string_view id);

/** Returns the selected questions, each kind sorted by id. Throws InputError with the
 nearest id if a pattern selects nothing. Throws InputError with all errors if a file has
 any: a broken selection is not used in part. */
Questions SelectQuestions(const ScenarioSelection& selection);

/** Returns the ids of those `questions`, selected by `selection`, that are not part of
 the catalogue in the folder `catalogue`: it has no file of that id, or one with different
 content. */
std::set<std::string, std::less<>> OutsideCatalogue(
    const ScenarioSelection& selection, const Questions& questions,
    const std::filesystem::path& catalogue);

}  // namespace touchstone
