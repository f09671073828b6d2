#include "cli/shell.h"

#include <array>
#include <cstdio>

#include <sys/wait.h>

#include "reports/text/shell_quoted.h"

namespace touchstone {

CommandResult RunInShell(const std::string& command) {
  constexpr int kNoShell = 127;
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {"", kNoShell};
  CommandResult result;
  std::array<char, 4096> buffer;
  for (std::size_t size;
       (size = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    result.text.append(buffer.data(), size);
  }
  const int status = pclose(pipe);
  result.code = WIFEXITED(status)     ? WEXITSTATUS(status)
                : WIFSIGNALED(status) ? 128 + WTERMSIG(status)
                                      : kNoShell;
  return result;
}

bool IsInstalled(const std::string& program) {
  return RunInShell("command -v " + ShellQuoted(program)).code == 0;
}

}  // namespace touchstone
