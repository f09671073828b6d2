// A GoogleTest file that checks your world engine against the laws that world files
// claim.
#include "my_world.h"

#include <gtest/gtest.h>
#include <oracles/oracle_registry.h>
#include <reports/gtest/moves_right.h>

TEST(MyWorld, MovesRight) {
  const auto mine = touchstone::MakeSimulator<MyWorld>("my_world", MyWorldSimulates());
  const auto oracles = touchstone::OracleRegistry::BuiltIn();
  EXPECT_TRUE(touchstone::MovesRight(*mine, WORLDS, oracles.Matching("ode")));
}
