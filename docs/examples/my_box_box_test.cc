// A GoogleTest file that checks your routine against certified truth. A failure also
// shows the answers of FCL, if FCL is installed.
#include <gtest/gtest.h>
#include <oracles/oracle_registry.h>
#include <reports/gtest/is_right.h>

#include "my_oracle.h"

using touchstone::Box;
using touchstone::Family;
using touchstone::IsRight;
using touchstone::ShapeKind;

class MyBoxBox : public testing::TestWithParam<Family> {};

TEST_P(MyBoxBox, IsRight) {
  const auto mine = touchstone::MakeOracle<Box, Box>("my_box_box", AskMyBoxBox);
  const auto oracles = touchstone::OracleRegistry::BuiltIn();
  EXPECT_TRUE(IsRight(*mine,
                      {.family = GetParam(), .A = ShapeKind::kBox, .B = ShapeKind::kBox},
                      oracles.Matching("fcl")));
}

INSTANTIATE_TEST_SUITE_P(Families, MyBoxBox, testing::ValuesIn(touchstone::AllFamilies()),
                         [](const auto& family) {
                           return std::string(touchstone::NameOf(family.param));
                         });
