#include "reports/text/shell_quoted.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(ShellQuoted, QuotesWhatAShellWouldExpand) {
  EXPECT_EQ(ShellQuoted("a b$c"), "'a b$c'");
  EXPECT_EQ(ShellQuoted("it's"), "'it'\\''s'");
  EXPECT_EQ(ShellQuoted(""), "''");
}

}  // namespace
}  // namespace touchstone
