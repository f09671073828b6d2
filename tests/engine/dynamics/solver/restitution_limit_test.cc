#include "engine/dynamics/solver/restitution_limit.h"

#include <gtest/gtest.h>

namespace cookbook {
namespace {

/** Returns the energy that is added at the fraction `s`. [J] */
double EnergyAt(double s, double elastic, double inelastic, double curvature) {
  return elastic + s * (inelastic - elastic - curvature) + s * s * curvature;
}

TEST(FractionWithoutGain, IsTheLeastThatAddsNoEnergy) {
  for (const double inelastic : {-0.01, -1.0, -30.0}) {
    for (const double curvature : {0.0, 0.5, 4.0}) {
      const double s = FractionWithoutGain(1, inelastic, curvature);
      EXPECT_NEAR(EnergyAt(s, 1, inelastic, curvature), 0, 1e-14);
      EXPECT_GT(EnergyAt(0.99 * s, 1, inelastic, curvature), 0);
    }
  }
}

// A solution without restitution adds energy only if the iterations ended too early.
TEST(FractionWithoutGain, IsOneIfEveryMeanAddsEnergy) {
  EXPECT_EQ(FractionWithoutGain(1, 0.9, 3), 1);
  EXPECT_EQ(FractionWithoutGain(1, 0.9, 0), 1);
  EXPECT_EQ(FractionWithoutGain(1, 2, 0), 1);
}

}  // namespace
}  // namespace cookbook
