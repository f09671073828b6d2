#include <string>

#include <gtest/gtest.h>

#include "reports/worlds/laws/laws.h"

namespace touchstone {
namespace {

TEST(TurnsOnce, IsTestedForEveryLaw) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (const Law& law : Laws()) {
    bool is_tested = false;
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
      const testing::TestSuite& suite = *all.GetTestSuite(i);
      if (suite.name() != std::string("TurnsOnce")) continue;
      for (int t = 0; t < suite.total_test_count(); ++t)
        is_tested = is_tested || suite.GetTestInfo(t)->name() == law.name;
    }
    EXPECT_TRUE(is_tested) << law.name;
  }
}

}  // namespace
}  // namespace touchstone
