#include "cli/shell.h"

#include <gtest/gtest.h>

#include "reports/text/shell_quoted.h"

namespace touchstone {
namespace {

TEST(RunInShell, ReturnsTheOutputAndHowItEnded) {
  const CommandResult result = RunInShell("echo out; echo more; exit 3");
  EXPECT_EQ(result.text, "out\nmore\n");
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(RunInShell("kill -9 $$").code, 128 + 9);
  EXPECT_EQ(RunInShell("echo " + ShellQuoted("it's $HOME")).text, "it's $HOME\n");
}

TEST(IsInstalled, FindsProgramsOfThePath) {
  EXPECT_TRUE(IsInstalled("sh"));
  EXPECT_FALSE(IsInstalled("no such program"));
}

}  // namespace
}  // namespace touchstone
