#include "reports/writers/plot.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(LineClass, IsTheSubjectsAloneAndOneOfEightForTheOthers) {
  EXPECT_EQ(LineClass(0), "line0");
  std::set<std::string> others;
  for (std::size_t oracle = 1; oracle < 40; ++oracle) others.insert(LineClass(oracle));
  EXPECT_EQ(others, (std::set<std::string>{"line1", "line2", "line3", "line4", "line5",
                                           "line6", "line7", "line8"}));
}

// Neighbours in a table have colours of their own.
TEST(LineClass, DiffersWithinEight) {
  for (std::size_t oracle = 1; oracle < 40; ++oracle) {
    for (std::size_t next = oracle + 1; next < oracle + 8; ++next) {
      EXPECT_NE(LineClass(oracle), LineClass(next));
    }
  }
}

}  // namespace
}  // namespace touchstone
