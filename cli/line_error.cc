#include "cli/line_error.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/did_you_mean.h"

namespace touchstone {
namespace {

using Names = std::vector<std::string_view>;

bool IsOption(const std::string& word) {
  return word.starts_with("--");
}

std::string NoSuchCommand(const CLI::App& app, const std::vector<std::string>& words) {
  Names commands;
  for (const CLI::App* command :
       app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  const std::string list = fmt::format("expected one of: {}", fmt::join(commands, ", "));
  if (words.empty()) {
    return "a command is missing; " + list + "; `touchstone --help` describes them";
  }
  return fmt::format("there is no command '{}'{}; {}", words.front(),
                     DidYouMean(words.front(), commands), list);
}

// `word` begins with a dash. "--jobs=4" is treated as "--jobs".
std::string NoSuchOption(const std::string& line, const CLI::App& command,
                         std::string_view word) {
  word = word.substr(0, word.find('='));
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  if (std::find(names.begin(), names.end(), word) != names.end()) {
    return fmt::format("{} comes before the command; expected `{} {}`", word, line, word);
  }
  const Names views(names.begin(), names.end());
  return fmt::format("`{}` has no option {}{}; expected one of: {}", line, word,
                     DidYouMean(word, views), fmt::join(views, ", "));
}

// Returns the option that has swallowed another one as its value, as --pair does in
// "--pair box --count 5"; null if there is none.
const CLI::Option* Swallower(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (option->nonpositional() && std::any_of(values.begin(), values.end(), IsOption))
      return option;
  }
  return nullptr;
}

// Returns what is wrong with the options that are given.
std::string WhatIsMissing(const CLI::App& command, const CLI::ParseError& error) {
  std::string what = error.what();
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->get_required() && option->count() == 0) {
      return fmt::format("{} is missing: {}", name, option->get_description());
    }
    if (static_cast<int>(option->results().size()) > option->get_items_expected_max())
      return fmt::format("{} is given more than once; expected it once", name);
    if (error.get_name() == "ArgumentMismatch" && what.starts_with(name + ":")) {
      return fmt::format("{} is incomplete; expected {} {}", name, name,
                         option->get_type_name());
    }
  }
  return what;
}

}  // namespace

std::string LineError(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const CLI::App& command = commands.empty() ? app : *commands.front();
  const std::string line =
      app.get_name() + (commands.empty() ? "" : " " + command.get_name());
  const std::vector<std::string> unknown = app.remaining(true);
  const auto option =
      std::find_if(unknown.begin(), unknown.end(),
                   [](const std::string& word) { return word.starts_with('-'); });
  if (option != unknown.end()) return NoSuchOption(line, command, *option);
  if (commands.empty()) return NoSuchCommand(app, unknown);
  std::string what = WhatIsMissing(command, error);
  if (const CLI::Option* const swallower = Swallower(command)) {
    what = fmt::format("{0} is incomplete; expected {0} {1}", swallower->get_name(),
                       swallower->get_type_name());
  } else if (!unknown.empty()) {
    what = fmt::format("'{}' is not expected", unknown.front());
  }
  return fmt::format("{}; `{} --help` shows its usage", what, line);
}

}  // namespace touchstone
