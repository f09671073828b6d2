#pragma once

#include <filesystem>
#include <string>

namespace touchstone {

/** A command for the shell, and the folder in which it runs. */
struct Command {
  std::string line;  ///< E.g. "python3 my_oracle.py".
  std::filesystem::path folder = ".";
};

}  // namespace touchstone
