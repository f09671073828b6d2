#include "cli/choose_setups.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/did_you_mean.h"
#include "cli/input_error.h"
#include "cli/select_oracles.h"

namespace touchstone {
namespace {

/** The three parts of "ORACLE:NAME=VALUE". */
struct Choice {
  std::string oracle;
  std::string name;
  std::string value;
};

Choice Split(const std::string& text) {
  const std::size_t equals = text.find('=');
  // Names of oracles may contain a colon, those of parameters do not.
  const std::size_t colon = text.rfind(':', equals);
  if (equals == std::string::npos || colon == std::string::npos) {
    throw InputError(fmt::format(
        "--set {} is no choice; expected ORACLE:NAME=VALUE, e.g. ode:contact_erp=0.2",
        text));
  }
  return {text.substr(0, colon), text.substr(colon + 1, equals - colon - 1),
          text.substr(equals + 1)};
}

const WorldParameter& ParameterOf(const OracleInfo& info, const std::string& name) {
  std::vector<std::string_view> names;
  for (const WorldParameter& parameter : info.parameters) {
    if (parameter.name == name) return parameter;
    names.push_back(parameter.name);
  }
  if (names.empty()) {
    throw InputError(
        fmt::format("{} has no settings to choose; expected an oracle that `touchstone "
                    "oracles --settings` lists with some",
                    info.name));
  }
  throw InputError(fmt::format("{} has no setting '{}'{}; expected one of: {}", info.name,
                               name, DidYouMean(name, names), fmt::join(names, ", ")));
}

double ValueOf(const WorldParameter& parameter, const Choice& choice) {
  double value = 0;
  const char* const end = choice.value.data() + choice.value.size();
  const auto read = std::from_chars(choice.value.data(), end, value);
  const bool is_number = read.ec == std::errc() && read.ptr == end;
  const std::string expected =
      Refusal(parameter, is_number ? value : parameter.least - 1);
  if (expected.empty()) return value;
  throw InputError(fmt::format("--set {}:{}={} is refused; expected {}", choice.oracle,
                               choice.name, choice.value, expected));
}

}  // namespace

void ChooseSetups(const SetupArguments& arguments, OracleRegistry& registry) {
  std::map<std::string, WorldSetup> setups;
  if (arguments.as_shipped) {
    for (const Oracle* oracle : registry.All())
      setups[oracle->info().name].as_shipped = true;
  }
  for (const std::string& text : arguments.set) {
    const Choice choice = Split(text);
    const OracleInfo& info = OracleNamed(registry, choice.oracle).info();
    WorldSetup& setup = setups[info.name];
    setup.as_shipped = arguments.as_shipped;
    setup.chosen[choice.name] = ValueOf(ParameterOf(info, choice.name), choice);
  }
  for (const auto& [name, setup] : setups) registry.SetUp(name, setup);
}

}  // namespace touchstone
