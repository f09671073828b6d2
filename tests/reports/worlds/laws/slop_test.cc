// A depth that an engine documents as left is granted where depths and places are judged,
// and nothing deeper.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kSlop = 5e-3;  // [m]

OracleInfo WithSlop(double slop) {
  OracleInfo info = DoubleEngine();
  info.slop = slop;
  info.slop_documented_by = slop > 0 ? "section 4" : "";
  return info;
}

/** A ball that starts on the ground, with a step so short that its fall is 1e-7 m. */
World BallOnGround() {
  World world;
  world.bodies = {BodyOf("ball", Sphere{0.5}, 1, {0, 0.5, 0}), GroundOf()};
  world.bodies[0].restitution = 0;
  world.bodies[1].restitution = 0;
  world.gravity_W = {0, -10, 0};
  world.dt = 1e-4;
  world.steps = 100;
  return world;
}

/** The ball `depth` below where it started, from the tenth step on. */
Trajectory Sunk(const World& world, double depth) {
  return Sampled(world, [&](double t) {
    WorldState state;
    for (std::size_t i = 0; i < 2; ++i) {
      const Body& placed = world.bodies[i].placed;
      const double sunk = i == 0 && t > 9.5e-4 ? depth : 0;
      state.bodies.push_back({placed.X_WB.p_WB - sunk * Eigen::Vector3d::UnitY(),
                              Eigen::Quaterniond(placed.X_WB.R_WB),
                              Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
    }
    return state;
  });
}

class Slop : public testing::TestWithParam<std::pair<const char*, MeasureKind>> {};

TEST_P(Slop, IsGrantedAndNoMore) {
  const char* law = GetParam().first;
  const MeasureKind measure = GetParam().second;
  const World world = BallOnGround();
  const auto judged = [&](double depth, double slop) {
    return Judge(world, Sunk(world, depth), ClaimOf(law, {"ball"}), WithSlop(slop));
  };
  EXPECT_TRUE(Passes(judged(0.99 * kSlop, kSlop)));
  // Laws of the settling distance grant it × 1.5.
  EXPECT_TRUE(Finds(judged(1.51 * kSlop, kSlop), measure));
  EXPECT_TRUE(Finds(judged(0.99 * kSlop, 0), measure));
  EXPECT_TRUE(Passes(judged(0, 0)));
}

TEST_P(Slop, IsQuotedWithItsOrigin) {
  const char* law = GetParam().first;
  const MeasureKind measure = GetParam().second;
  const World world = BallOnGround();
  const auto because = [&](double slop) {
    return Of(Judge(world, Sunk(world, 0), ClaimOf(law, {"ball"}), WithSlop(slop)),
              measure)
        .tolerance.because;
  };
  EXPECT_THAT(because(kSlop),
              testing::HasSubstr("the slop of 0.005 m documented by section 4"));
  EXPECT_THAT(because(0), testing::Not(testing::HasSubstr("slop")));
}

INSTANTIATE_TEST_SUITE_P(
    Laws, Slop,
    testing::Values(std::pair("never_penetrates", MeasureKind::kPenetration),
                    std::pair("penetration_score", MeasureKind::kPenetration),
                    std::pair("rests", MeasureKind::kRestMotion),
                    std::pair("incline", MeasureKind::kPositionError),
                    std::pair("rolls", MeasureKind::kPositionError)),
    [](const auto& instance) { return std::string(instance.param.first); });

TEST(SlopOfABox, LetsItTurnByTheSlopOverItsWidth) {
  World world = BallOnGround();
  world.bodies[0].name = "box";
  world.bodies[0].placed.shape = Box{{0.5, 0.5, 0.5}};
  const auto turned = [&](double angle) {
    Trajectory trajectory = Sunk(world, 0);
    for (std::size_t s = 10; s < trajectory.samples.size(); ++s) {
      trajectory.samples[s].bodies[0].q_WB =
          Turned(Eigen::Quaterniond::Identity(), {0, 0, angle});
    }
    return Judge(world, trajectory, ClaimOf("rests", {"box"}), WithSlop(kSlop));
  };
  EXPECT_TRUE(Passes(turned(kSlop)));  // Over a width of 1 m.
  EXPECT_TRUE(Finds(turned(2.5 * kSlop), MeasureKind::kRestMotion));
}

}  // namespace
}  // namespace touchstone
