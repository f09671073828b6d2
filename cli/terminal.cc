#include "cli/terminal.h"

#include <cstdlib>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace touchstone {
namespace {

std::string_view Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::size_t WidthOf(int output) {
  winsize size{};
  if (isatty(output) != 1 || ioctl(output, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

}  // namespace

Terminal DetectTerminal() {
  const bool dumb = Environment("TERM") == "dumb";
  return {
      .colours = isatty(STDOUT_FILENO) == 1 && Environment("NO_COLOR").empty() && !dumb,
      .progress = isatty(STDERR_FILENO) == 1 && !dumb,
      .width = WidthOf(STDOUT_FILENO)};
}

}  // namespace touchstone
