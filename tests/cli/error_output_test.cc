#include "cli/error_output.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchstone {
namespace {

/** What is read of a child process that prints `text`. */
ErrorOutput::Said ReadOf(std::string_view text) {
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
  return output.Read();
}

TEST(ErrorOutput, CountsLinesAndKeepsTheLast) {
  const ErrorOutput::Said said = ReadOf("one\n\n  \ntwo\tof two\n");
  EXPECT_EQ(said.lines, 2);
  EXPECT_EQ(said.last, "two of two");
}

TEST(ErrorOutput, ALineNeedsNoEnd) {
  const ErrorOutput::Said said = ReadOf("one\ntwo");
  EXPECT_EQ(said.lines, 2);
  EXPECT_EQ(said.last, "two");
}

TEST(ErrorOutput, IsEmptyOfAChildThatPrintsNothing) {
  const ErrorOutput::Said said = ReadOf("");
  EXPECT_EQ(said.lines, 0);
  EXPECT_EQ(said.last, "");
}

TEST(ErrorOutput, KeepsTheBeginningOfAnEndlessLineAndOfAnEndlessOutput) {
  const std::string line(1000, 'x');
  const ErrorOutput::Said said = ReadOf(line);
  EXPECT_EQ(said.lines, 1);
  EXPECT_EQ(said.last, std::string(200, 'x'));
  std::string lines;
  for (int i = 0; i < 70 << 10; ++i) lines += std::string(1023, 'y') + '\n';
  EXPECT_EQ(ReadOf(lines).lines, 64 << 10);
}

}  // namespace
}  // namespace touchstone
