#include "reports/writers/describe.h"

#include <gtest/gtest.h>

#include "reports/referee/referee.h"

namespace touchstone {
namespace {

std::string StateOf(const ContactQuery& query) {
  const std::string sentence = Describe(query, ComputeContactTruth(query));
  return sentence.substr(0, sentence.find(':'));
}

// An engine that misses the first pair is wrong: the sentence must not say otherwise.
TEST(Describe, DecidesFlushBodiesWhoseNumbersNeedNoRounding) {
  const Body cube{Box{{1, 1, 1}}, Pose{}};
  const auto at = [&](double x) {
    return Body{Box{{1, 1, 1}}, Pose::FromMatrix({x, 0, 0}, Eigen::Matrix3d::Identity())};
  };
  EXPECT_EQ(StateOf({cube, at(2)}), "Touching, exactly");
  EXPECT_EQ(StateOf({cube, at(2.5)}), "Apart");
  EXPECT_EQ(StateOf({cube, at(1.5)}), "Touching");
}

TEST(Describe, LeavesFlushBodiesUndecidedWhoseNumbersAreRounded) {
  const Pose X_WA = Pose::FromQuaternion(
      {0.3, 0.7, -0.2}, Eigen::Quaterniond(0.9, 0.1, -0.3, 0.3).normalized());
  const Body A{Box{{1, 1, 1}}, X_WA};
  const Body B{Box{{1, 1, 1}},
               Pose::FromMatrix(X_WA * Eigen::Vector3d(2, 0.1, 0.2), X_WA.R_WB)};
  EXPECT_EQ(StateOf({A, B}), "Undecided");
}

}  // namespace
}  // namespace touchstone
