#pragma once

#include <string>
#include <vector>

#include "oracles/oracle_registry.h"

namespace touchstone {

/** The options that add oracles that are programs of their own. */
struct ExternalOracleArguments {
  std::vector<std::string> commands;  ///< "NAME=COMMAND".
  /** A file of them; empty: kOraclesFile in the working folder, if there is one. */
  std::string file;
};

/** The name of the file of oracles that is read unless another is named. */
inline constexpr const char* kOraclesFile = "oracles.toml";

/** Starts the programs, all at once, and adds them to `registry`. One of a file that does
 not start becomes a missing oracle, so that others can be asked. Throws InputError for a
 command that does not start, a name that is taken, and every error of a file. */
void AddExternalOracles(const ExternalOracleArguments& arguments,
                        OracleRegistry& registry);

}  // namespace touchstone
