#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> TextOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string text;
  std::array<char, 1 << 14> chunk;
  while (file.read(chunk.data(), chunk.size()), file.gcount() > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
  }
  // Opening a folder succeeds; reading it fails only here.
  if (file.bad()) return std::nullopt;
  return text;
}

/** Returns the path of `file` relative to `folder` as an id: no extension, forward
 slashes. */
std::string IdOf(const fs::path& file, const fs::path& folder) {
  return file.lexically_relative(folder).replace_extension().generic_string();
}

bool EndsWithLevels(std::string_view path, std::string_view levels) {
  return path == levels ||
         (path.ends_with(levels) && path[path.size() - levels.size() - 1] == '/');
}

/** Collects the scenarios of files read one by one, and checks ids across files. */
class CatalogueReader {
 public:
  void Add(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      AddFolder(path);
    } else {
      AddFile(path);
    }
  }

  Catalogue Finish() && {
    const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
    std::sort(catalogue_.scenarios.begin(), catalogue_.scenarios.end(), by_id);
    std::sort(catalogue_.worlds.begin(), catalogue_.worlds.end(), by_id);
    std::stable_sort(catalogue_.diagnostics.begin(), catalogue_.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                       return std::tie(a.file, a.line, a.column) <
                              std::tie(b.file, b.line, b.column);
                     });
    return std::move(catalogue_);
  }

 private:
  void AddFolder(const fs::path& folder) {
    std::set<fs::path> files;  // Sorted: directory order depends on the system.
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end;
         !error && entry != end; entry.increment(error)) {
      std::error_code unknown;
      if (entry->path().extension() == ".toml" && !entry->is_directory(unknown)) {
        files.insert(entry->path());
      }
    }
    if (error) {
      Report(folder, fmt::format("cannot be read: {}", error.message()), "a folder");
    } else if (files.empty()) {
      Report(folder, "contains no scenario", "at least one .toml file");
    }
    for (const fs::path& file : files) AddFile(file, &folder);
  }

  /** `folder`: the folder being read, or null if the file itself was named. */
  void AddFile(const fs::path& file, const fs::path* folder = nullptr) {
    // A file given twice, or also contained in a given folder, is not its own duplicate.
    std::error_code error;
    const fs::path real = fs::weakly_canonical(file, error);
    if (!seen_.insert(error ? file : real).second) return;

    ReadResult read = ReadScenarioFile(file);
    for (Diagnostic& diagnostic : read.diagnostics) {
      catalogue_.diagnostics.push_back(std::move(diagnostic));
    }
    for (Diagnostic& note : read.notes) catalogue_.notes.push_back(std::move(note));
    if (read.stated_id) {
      // A copied file that kept its id is reported for its path only.
      const bool is_in_place =
          folder == nullptr || CheckPath(*read.stated_id, file, *folder);
      if (!is_in_place || !CheckUnique(*read.stated_id, file)) return;
    }
    if (read.scenario) catalogue_.scenarios.push_back(std::move(*read.scenario));
    if (read.world) catalogue_.worlds.push_back(std::move(*read.world));
  }

  bool CheckUnique(const StatedId& stated, const fs::path& file) {
    const std::string place =
        fmt::format("{}:{}:{}", file.generic_string(), stated.line, stated.column);
    const auto [first, is_new] = place_of_id_.emplace(stated.id, place);
    if (!is_new) {
      catalogue_.diagnostics.push_back(
          {file.generic_string(), stated.line, stated.column,
           fmt::format("id \"{}\" is already used by {}", stated.id, first->second),
           "a unique id"});
    }
    return is_new;
  }

  /** Checks that the file's path ends in its id, and that its id ends in the path below
   `folder`. */
  bool CheckPath(const StatedId& stated, const fs::path& file, const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
    const std::string below = IdOf(file, folder);
    if (EndsWithLevels(stated.id, below) &&
        EndsWithLevels(IdOf(whole, whole.root_path()), stated.id)) {
      return true;
    }
    catalogue_.diagnostics.push_back(
        {file.generic_string(), stated.line, stated.column,
         fmt::format("id \"{}\" is not the path of {}", stated.id, file.generic_string()),
         fmt::format("\"{}\"", below)});
    return false;
  }

  void Report(const fs::path& path, std::string what, std::string expected) {
    catalogue_.diagnostics.push_back(
        {path.generic_string(), 0, 0, std::move(what), std::move(expected)});
  }

  Catalogue catalogue_;
  std::set<fs::path> seen_;
  std::map<std::string, std::string>
      place_of_id_;  ///< "file:line:column" of the first use, indexed by id.
};

}  // namespace

ReadResult ReadScenarioFile(const fs::path& file) {
  const std::string name = file.generic_string();
  if (const std::optional<std::string> text = TextOf(file)) {
    return ReadScenario(*text, name);
  }
  ReadResult result;
  result.diagnostics.push_back({name, 0, 0, "cannot be read", "a readable file"});
  return result;
}

Catalogue ReadCatalogue(std::span<const fs::path> files_and_folders) {
  CatalogueReader reader;
  for (const fs::path& path : files_and_folders) reader.Add(path);
  return std::move(reader).Finish();
}

Catalogue ReadCatalogue(const fs::path& file_or_folder) {
  return ReadCatalogue(std::span(&file_or_folder, 1));
}

}  // namespace touchstone
