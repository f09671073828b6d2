#include "reports/worlds/study/ensemble_statistics.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "scenarios/generators/random.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

/** A ball of 1 kg and one of 3 kg, 4 m apart. */
World TwoBalls() {
  World world;
  world.gravity_W = {0, 0, -10};
  world.bodies = {BodyOf("light", Sphere{0.1}, 1, {0, 0, 0}),
                  BodyOf("heavy", Sphere{0.1}, 3, {4, 0, 0}),
                  BodyOf("floor", Sphere{9}, 0, {0, 0, -20})};
  world.dt = 0.1;
  world.steps = 2;
  return world;
}

/** A motion with both balls at `height` and the light one at `speed`. */
Trajectory At(double height, double speed) {
  const World world = TwoBalls();
  return Sampled(world, [&](double) {
    WorldState state;
    for (const RigidBody& body : world.bodies) {
      state.bodies.push_back({body.placed.X_WB.p_WB + Eigen::Vector3d(0, 0, height),
                              Eigen::Quaterniond::Identity(),
                              {0, 0, 0},
                              {0, 0, 0}});
    }
    state.bodies[0].v_WB.x() = speed;
    return state;
  });
}

TEST(StatisticsOf, AreMeansAndDeviationsOfTheFinalStates) {
  const std::vector<Trajectory> motions = {At(1, 2), At(2, 4), At(3, 6)};
  const EnsembleStatistics of = StatisticsOf(TwoBalls(), motions);
  EXPECT_EQ(of.members, 3);
  EXPECT_DOUBLE_EQ(of.kinetic_energy.mean, (2.0 + 8.0 + 18.0) / 3);
  EXPECT_DOUBLE_EQ(of.height.mean, 2);
  EXPECT_DOUBLE_EQ(of.height.deviation, 1);
  // 1 kg at 3 m from the common centre, 3 kg at 1 m.
  EXPECT_DOUBLE_EQ(of.width.mean, std::sqrt(3.0));
  EXPECT_LE(of.width.deviation, 1e-15);
}

TEST(StatisticsOf, HaveNoMembersIfOneWasNotAnswered) {
  std::vector<Trajectory> motions = {At(1, 2), At(2, 4), Trajectory()};
  EXPECT_EQ(StatisticsOf(TwoBalls(), motions).members, 0);
  motions.resize(1);
  EXPECT_EQ(StatisticsOf(TwoBalls(), motions).members, 0);
}

// Welch's quotient: two ensembles of 8 members with a standard deviation of 1 each have a
// joint standard error of ½ and 14 degrees of freedom. Student's t exceeds 4.1405 in one
// of 1000 cases.
TEST(Differ, BeyondTheQuantileOfStudentsDistribution) {
  const Statistic here{10, 1};
  EXPECT_FALSE(Differ(here, 8, {10 + 0.5 * 4.140, 1}, 8));
  EXPECT_TRUE(Differ(here, 8, {10 + 0.5 * 4.141, 1}, 8));
}

TEST(Differ, NotByRounding) {
  EXPECT_FALSE(Differ({10, 0}, 8, {10 * (1 + 1e-12), 0}, 8));
  EXPECT_TRUE(Differ({10, 0}, 8, {10 * (1 + 1e-6), 0}, 8));
}

TEST(Differ, ByChanceInOneOfAThousandTrials) {
  Random random({7, 1});
  const auto ensemble = [&] {
    double sum = 0;
    double squares = 0;
    for (int member = 0; member < 8; ++member) {
      // Nearly normal: the sum of twelve uniform numbers.
      double value = 0;
      for (int k = 0; k < 12; ++k) value += random.Uniform(-0.5, 0.5);
      sum += value;
      squares += value * value;
    }
    return Statistic{sum / 8, std::sqrt((squares - sum * sum / 8) / 7)};
  };
  int differ = 0;
  for (int trial = 0; trial < 20000; ++trial)
    differ += Differ(ensemble(), 8, ensemble(), 8);
  // 20 are expected, with a standard deviation of 4.5.
  EXPECT_GT(differ, 2);
  EXPECT_LT(differ, 40);
}

}  // namespace
}  // namespace touchstone
