#include <filesystem>

#include "cli/command_line.h"

namespace {

// Data folder of an installed program, relative to the program: the prefix may be moved.
std::filesystem::path DataBesideProgram() {
  std::error_code error;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share/touchstone";
}

}  // namespace

int main(int argc, char** argv) {
  touchstone::CommandLineDefaults defaults;
  if (std::filesystem::exists(DataBesideProgram())) defaults.data = DataBesideProgram();
  return touchstone::RunCommandLine(argc, argv, touchstone::OracleRegistry::BuiltIn(),
                                    defaults);
}
