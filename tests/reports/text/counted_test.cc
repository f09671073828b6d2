#include "reports/text/counted.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(Counted, UsesThePluralExceptForOne) {
  EXPECT_EQ(Counted(0, "scenario"), "0 scenarios");
  EXPECT_EQ(Counted(1, "scenario"), "1 scenario");
  EXPECT_EQ(Counted(2, "scenario"), "2 scenarios");
  EXPECT_EQ(Counted(1, "entry", "entries"), "1 entry");
  EXPECT_EQ(Counted(3, "entry", "entries"), "3 entries");
}

}  // namespace
}  // namespace touchstone
