#include "oracles/protocol/oracles_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace touchstone {
namespace {

/** An oracle and its line in the file. */
struct Placed {
  toml::source_position at;
  NamedCommand oracle;
};

}  // namespace

std::string RefusalOfName(const std::string& name) {
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./@+";
  if (!name.empty() && name.find_first_not_of(kLetters) == std::string::npos &&
      name != "all") {
    return "";
  }
  return "a name of letters, digits and _ - . / @ +, other than \"all\"";
}

OraclesFileResult ReadOraclesFile(const std::filesystem::path& file) {
  OraclesFileResult result;
  const auto add = [&](const toml::source_position& at, std::string what,
                       std::string expected) {
    result.diagnostics.push_back({file.string(), static_cast<int>(at.line),
                                  static_cast<int>(at.column), std::move(what),
                                  std::move(expected)});
  };
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) {
    add({}, "cannot be read", "a file of oracles, NAME = \"COMMAND\" on each line");
    return result;
  }
  std::vector<Placed> placed;
  try {
    const toml::table root = toml::parse(text, file.string());
    for (const auto& [key, node] : root) {
      const std::string name(key.str());
      const std::string expected = RefusalOfName(name);
      if (!expected.empty())
        add(key.source().begin, fmt::format("\"{}\" is no name", name), expected);
      const auto command = node.value_exact<std::string>();
      if (!command || command->empty()) {
        add(node.source().begin, fmt::format("{} has no command", name),
            "a string that the shell can run, e.g. \"python3 my_oracle.py\"");
        continue;
      }
      const std::filesystem::path folder = file.parent_path();
      placed.push_back(
          {key.source().begin, {name, {*command, folder.empty() ? "." : folder}}});
    }
  } catch (const toml::parse_error& error) {
    add(error.source().begin, std::string(error.description()), "valid TOML");
  }
  if (!result.diagnostics.empty()) {
    std::ranges::stable_sort(result.diagnostics, {}, [](const Diagnostic& diagnostic) {
      return std::tuple(diagnostic.line, diagnostic.column);
    });
    return result;
  }
  std::ranges::stable_sort(placed, {}, [](const Placed& p) { return p.at.line; });
  result.oracles.emplace();
  for (Placed& p : placed) result.oracles->push_back(std::move(p.oracle));
  return result;
}

}  // namespace touchstone
