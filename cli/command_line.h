#pragma once

#include <filesystem>
#include <string>

#include "cli/data_folder.h"
#include "oracles/oracle_registry.h"

namespace touchstone {

/** The values that the command line uses where no option overrides them. */
struct CommandLineDefaults {
  std::string subject = "cookbook";  ///< The oracle under examination.
  /** Folder that holds catalogue/ and known_discrepancies.toml. */
#ifdef TOUCHSTONE_DATA_DIR  // Defined by the installed package, which can be moved.
  std::filesystem::path data = TOUCHSTONE_DATA_DIR;
#else
  std::filesystem::path data = DataFolderOfSources();
#endif
};

/** The whole `touchstone` program, with the oracles of `registry`. To add your own, add
 it to OracleRegistry::BuiltIn() and call this from main(). Returns the exit code: 0 all
 pass or known, 1 failures, 2 bad input or nothing verified. */
int RunCommandLine(int argc, const char* const* argv, OracleRegistry registry,
                   const CommandLineDefaults& defaults = {});

}  // namespace touchstone
