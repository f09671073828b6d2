#include "reports/sweep/file_series.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "reports/text/fnv_1a.h"
#include "reports/text/shell_quoted.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

bool IsLetterOrDigit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/** Returns the name of a file as a level of an id: a-z, 0-9 and _. */
std::string LevelOf(const std::string& file) {
  const std::filesystem::path path(file);
  // A path that ends with a slash has no file name.
  std::string level = (path.has_filename() ? path : path.parent_path()).stem().string();
  for (char& c : level) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (!IsLetterOrDigit(c)) c = '_';
  }
  return level;
}

/** Returns `word` as a POSIX shell reads it, in quotation marks only if it needs them. */
std::string AsShellWord(const std::string& word) {
  const bool is_plain = std::ranges::all_of(word, [](char c) {
    return IsLetterOrDigit(c) ||
           std::string_view("_-./+,:@%").find(c) != std::string::npos;
  });
  return is_plain ? word : ShellQuoted(word);
}

}  // namespace

std::string DigestOf(const std::vector<Scenario>& questions) {
  Fnv1a hash;
  for (Scenario question : questions) {
    question.id = question.title = question.source = '-';
    hash.Take(WriteScenario(question));
  }
  return fmt::format("{:016x}", hash.value());
}

std::string IdOf(const FileSeries& series, std::uint64_t index) {
  // Indices have equal width, so that ids sort as indices do.
  return fmt::format("sweep/from/{}_{}/{}_{}/{:020}", LevelOf(series.file), series.digest,
                     NameOf(series.A), NameOf(series.B), index);
}

Scenario ScenarioAt(const FileSeries& series, std::uint64_t index) {
  Scenario scenario = series.questions->at(index);
  scenario.id = IdOf(series, index);
  return scenario;
}

std::string ReplayOf(const FileSeries& series, std::uint64_t index) {
  return fmt::format(
      "touchstone sweep contact --from {} --pair {} {} --first {} --count 1",
      AsShellWord(series.file), NameOf(series.A), NameOf(series.B), index);
}

}  // namespace touchstone
