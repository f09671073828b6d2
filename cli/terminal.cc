#include "cli/terminal.h"

#include <cstdlib>
#include <string_view>

#include <unistd.h>

namespace touchstone {
namespace {

std::string_view Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

Terminal DetectTerminal() {
  const bool dumb = Environment("TERM") == "dumb";
  return {
      .colours = isatty(STDOUT_FILENO) == 1 && Environment("NO_COLOR").empty() && !dumb,
      .progress = isatty(STDERR_FILENO) == 1 && !dumb};
}

}  // namespace touchstone
