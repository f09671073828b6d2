#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "oracles/protocol/command.h"
#include "scenarios/diagnostic.h"

namespace touchstone {

/** An external oracle, before it is started. */
struct NamedCommand {
  std::string name;
  Command command;
};

/** The oracles of a file, or all errors in it. */
struct OraclesFileResult {
  std::optional<std::vector<NamedCommand>> oracles;  ///< In the order of the file.
  std::vector<Diagnostic> diagnostics;               ///< In the order of lines.
};

/** Returns why `name` cannot be the name of an oracle, as what is expected; empty if it
 can be: it is a word that options, ledgers and lists of names can hold. */
std::string RefusalOfName(const std::string& name);

/** Reads a file of external oracles: a line NAME = "COMMAND" for each. The commands run
 in the folder of the file. */
OraclesFileResult ReadOraclesFile(const std::filesystem::path& file);

}  // namespace touchstone
