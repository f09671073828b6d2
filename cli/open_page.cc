#include "cli/open_page.h"

#include <array>
#include <string>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/input_error.h"

namespace touchstone {

void OpenPage(const std::filesystem::path& page) {
#ifdef __APPLE__
  std::string program = "open";
#else
  std::string program = "xdg-open";
#endif
  std::string file = std::filesystem::absolute(page).string();
  const std::array<char*, 3> arguments = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  int status = 1;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(),
                   environ) != 0 ||
      waitpid(child, &status, 0) != child || status != 0) {
    throw InputError(fmt::format("{} cannot open {}; expected a desktop with a browser",
                                 program, file));
  }
}

}  // namespace touchstone
