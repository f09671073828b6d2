#include "cli/external_oracles.h"

#include <filesystem>
#include <future>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "oracles/protocol/command.h"
#include "oracles/protocol/external_oracle.h"
#include "oracles/protocol/oracles_file.h"
#include "reports/text/counted.h"

namespace touchstone {
namespace {

/** An oracle that is being started. */
struct Starting {
  std::string name;
  bool is_of_file;
  std::future<std::unique_ptr<Oracle>> oracle;
};

NamedCommand CommandFrom(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size()) {
    throw InputError(fmt::format(
        "--oracle {} is no program; expected NAME=COMMAND, e.g. 'mine=python3 "
        "my_oracle.py'",
        text));
  }
  NamedCommand oracle{text.substr(0, equals), {text.substr(equals + 1)}};
  const std::string expected = RefusalOfName(oracle.name);
  if (expected.empty()) return oracle;
  throw InputError(
      fmt::format("--oracle: \"{}\" is no name; expected {}", oracle.name, expected));
}

std::vector<NamedCommand> CommandsOf(const std::filesystem::path& file) {
  OraclesFileResult result = ReadOraclesFile(file);
  if (result.oracles) return *std::move(result.oracles);
  std::string text =
      Counted(result.diagnostics.size(), "error") + " in the file of oracles";
  for (const Diagnostic& diagnostic : result.diagnostics)
    text += fmt::format("\n{}", ToString(diagnostic));
  throw InputError(text);
}

}  // namespace

void AddExternalOracles(const ExternalOracleArguments& arguments,
                        OracleRegistry& registry) {
  std::vector<Starting> starting;
  const auto start = [&](const NamedCommand& oracle, bool is_of_file) {
    starting.push_back({oracle.name, is_of_file, std::async(std::launch::async, [oracle] {
                          return MakeExternalOracle(oracle.name, oracle.command);
                        })});
  };
  for (const std::string& text : arguments.commands) start(CommandFrom(text), false);
  if (!arguments.file.empty() || std::filesystem::exists(kOraclesFile)) {
    for (const NamedCommand& oracle :
         CommandsOf(arguments.file.empty() ? kOraclesFile : arguments.file)) {
      start(oracle, true);
    }
  }
  for (Starting& one : starting) {
    try {
      registry.Add(one.oracle.get());
    } catch (const std::runtime_error& error) {
      if (!one.is_of_file) {
        throw InputError(fmt::format(
            "the oracle {} cannot be asked: {}; expected a program that speaks "
            "the oracle protocol (docs/oracle_protocol.md)",
            one.name, error.what()));
      }
      registry.AddMissing(
          {one.name, std::string("its program cannot be asked: ") + error.what()});
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}; expected another name", error.what()));
    }
  }
}

}  // namespace touchstone
