#include "cli/error_output.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchstone {
namespace {

/** Returns the last line kept of a child process that prints `text`. */
std::string LastLineOfChild(std::string_view text) {
  const ErrorOutput output;
  const pid_t child = fork();
  if (child == 0) {
    output.Take();
    while (!text.empty()) {
      const ssize_t count = write(STDERR_FILENO, text.data(), text.size());
      if (count <= 0) break;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    _exit(0);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  return output.LastLine();
}

TEST(ErrorOutput, KeepsTheLastLineThatIsNotEmpty) {
  EXPECT_EQ(LastLineOfChild("one\ntwo\tof two\n\n  \n"), "two of two");
}

TEST(ErrorOutput, KeepsALastLineWithoutANewline) {
  EXPECT_EQ(LastLineOfChild("one\ntwo"), "two");
}

TEST(ErrorOutput, IsEmptyIfTheChildPrintsNothing) {
  EXPECT_EQ(LastLineOfChild(""), "");
}

TEST(ErrorOutput, EndsAfter64MebibytesAndDoesNotKillTheChild) {
  std::string lines;
  for (int i = 0; i < 70 << 10; ++i) {
    std::string line = std::to_string(i);
    line.resize(1023, ' ');
    lines += line + '\n';
  }
  EXPECT_EQ(LastLineOfChild(lines), std::to_string((64 << 10) - 1));
}

}  // namespace
}  // namespace touchstone
