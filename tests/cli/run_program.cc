#include "run_program.h"

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchstone {
namespace {

std::string Contents(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

int CodeOf(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

Ended InPipe(const std::string& command) {
  const std::string base = testing::TempDir() + "cli_test_" + std::to_string(getpid());
  const int status =
      std::system((command + " >" + base + ".out 2>" + base + ".err </dev/null").c_str());
  Ended ended{CodeOf(status), Contents(base + ".out"), Contents(base + ".err")};
  unlink((base + ".out").c_str());
  unlink((base + ".err").c_str());
  return ended;
}

bool CanOpenTerminals() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal >= 0) close(terminal);
  return terminal >= 0;
}

Ended OnTerminal(const std::string& command) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  Ended ended{-1, "", ""};
  std::array<char, 4096> buffer;
  // On Linux, read() fails with EIO once the last writer has exited.
  for (ssize_t size; (size = read(terminal, buffer.data(), buffer.size())) > 0;) {
    ended.out.append(buffer.data(), static_cast<std::size_t>(size));
  }
  int status = 0;
  waitpid(child, &status, 0);
  close(terminal);
  ended.code = CodeOf(status);
  return ended;
}

}  // namespace touchstone
