#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

namespace cookbook::test {

/** A test that runs once for each SIMD target of this processor, with the dispatch
 restricted to its parameter. */
class OnTarget : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { Choose(GetParam()); }
  void TearDown() override { Choose(kAll); }

  static constexpr std::int64_t kAll = 0;

  static void Choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

inline std::vector<std::int64_t> Targets() {
  return hwy::SupportedAndGeneratedTargets();
}

inline std::string NameOfTarget(const testing::TestParamInfo<std::int64_t>& target) {
  return hwy::TargetName(target.param);
}

}  // namespace cookbook::test
