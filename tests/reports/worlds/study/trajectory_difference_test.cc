#include "reports/worlds/study/trajectory_difference.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();

World OneBall() {
  World world;
  world.bodies = {BodyOf("ball", Sphere{0.5}, 2, {0.3, 1.7, -0.4})};
  world.particles = {{"drop", {-1.1, 3.3, 0.2}, {0.4, 0, 0.1}, 0.2}};
  world.dt = 0.01;
  world.steps = 50;
  return world;
}

TEST(DistanceBetween, IsTheLargestOverCentresAndPoints) {
  const Trajectory a = FreeFlight(OneBall());
  Trajectory b = a;
  b.samples[3].bodies[0].p_WB += Eigen::Vector3d(0.3, 0, 0.4);
  EXPECT_NEAR(DistanceBetween(a, b, 0, kEver), 0.5, 1e-15);
  b.samples[5].particles[0].p_W.z() -= 0.75;
  EXPECT_NEAR(DistanceBetween(a, b, 0, kEver), 0.75, 1e-15);
}

TEST(DistanceBetween, CountsARotationAsAngleTimesRadius) {
  const Trajectory a = FreeFlight(OneBall());
  Trajectory b = a;
  Eigen::Quaterniond& q = b.samples[9].bodies[0].q_WB;
  q = Turned(q, {0, 0.25, 0});
  EXPECT_NEAR(DistanceBetween(a, b, 2, kEver), 0.5, 1e-12);
  q.coeffs() = -q.coeffs();  // The same orientation.
  EXPECT_NEAR(DistanceBetween(a, b, 2, kEver), 0.5, 1e-12);
}

TEST(DistanceBetween, EndsAtTheHorizon) {
  const Trajectory a = FreeFlight(OneBall());
  Trajectory b = a;
  b.samples[30].bodies[0].p_WB.x() += 1;
  EXPECT_EQ(DistanceBetween(a, b, 0, 0.295), 0);
  EXPECT_NEAR(DistanceBetween(a, b, 0, 0.305), 1, 1e-15);
}

TEST(LargestDifference, NamesBothPositions) {
  const World world = OneBall();
  const Trajectory a = FreeFlight(world);
  Trajectory b = a;
  const auto words = [&](double until) {
    return InWords(LargestDifference(world, a, b, until), "");
  };
  EXPECT_EQ(LargestDifference(world, a, b, kEver).kind, ProofKind::kNone);
  EXPECT_EQ(words(kEver), "");
  b.samples[3].bodies[0].p_WB.x() += 1;
  b.samples[30].particles[0].p_W = {1, 2, 3};
  const Proof whole = LargestDifference(world, a, b, kEver);
  EXPECT_EQ(whole.kind, ProofKind::kPlaces);
  EXPECT_EQ(whole.time, a.times[30]);
  EXPECT_EQ(whole.body, "drop");
  ASSERT_EQ(whole.points_W.size(), 2U);
  EXPECT_EQ(whole.points_W[1], Eigen::Vector3d(1, 2, 3));
  EXPECT_NE(words(kEver).find("at 0.3 s “drop” is at (-0.98, "), std::string::npos);
  EXPECT_NE(words(kEver).find(" and (1, 2, 3)"), std::string::npos);
  EXPECT_EQ(words(0.1).find("at 0.03 s “ball” is at (0.3, "), 0u);
}

TEST(LargestDifference, IsWrittenWithTheDigitsThatShowIt) {
  const Proof near{.kind = ProofKind::kPlaces,
                   .points_W = {{0.2, 0.29, -0.1}, {0.2, 0.29, -0.1 - 3e-11}},
                   .body = "box",
                   .time = 2};
  EXPECT_EQ(InWords(near, ""),
            "at 2 s “box” is at (0.2, 0.29, -0.1) and (0.2, 0.29, -0.10000000003), 3e-11 "
            "m apart");
  // The measure is distance + angle × radius: each part is told.
  const Proof turned{.kind = ProofKind::kPlaces,
                     .rest = 3.04,
                     .points_W = {{0, 0, 0}, {0, 0.3, 0.4}},
                     .body = "ball",
                     .time = 1.35};
  EXPECT_EQ(
      InWords(turned, ""),
      "at 1.35 s “ball” is at (0, 0, 0) and (0, 0.3, 0.4), 0.5 m and 3.04 rad apart");
}

TEST(DistanceBetween, TreatsANanAsTheLargest) {
  const Trajectory a = FreeFlight(OneBall());
  Trajectory b = a;
  b.samples[3].particles[0].p_W.x() = std::numeric_limits<double>::quiet_NaN();
  b.samples[4].particles[0].p_W.x() += 1;
  EXPECT_FALSE(DistanceBetween(a, b, 0, kEver) <= 1);
}

TEST(FirstDifference, TreatsZerosOfEitherSignAsEqual) {
  const World world = OneBall();
  Trajectory a = FreeFlight(world);
  a.samples[0].bodies[0].w_WB.x() = 0.0;
  Trajectory b = a;
  b.samples[0].bodies[0].w_WB.x() = -0.0;
  EXPECT_EQ(FirstDifference(world, a, b).sentence, "");
  b.samples.pop_back();
  const CitingProof shorter = FirstDifference(world, a, b);
  EXPECT_THAT(shorter.sentence, testing::HasSubstr("one ends and the other goes on"));
  EXPECT_EQ(shorter.cited.time, a.times.back());
}

TEST(FirstDifference, NamesTimeBodyAndField) {
  const World world = OneBall();
  const Trajectory a = FreeFlight(world);
  Trajectory b = a;
  b.samples[20].bodies[0].v_WB.y() = 8.5;
  b.samples[30].bodies[0].p_WB.x() = 1;
  const CitingProof first = FirstDifference(world, a, b);
  EXPECT_THAT(first.sentence, testing::StartsWith("at 0.2 s “ball” velocity.y is -1.96"));
  EXPECT_EQ(first.cited, (Cited{{"ball"}, a.times[20], {}}));
  EXPECT_EQ(FirstDifference(world, a, a).sentence, "");
}

TEST(ExtrapolatedToZeroStep, RemovesTheErrorOfFirstOrder) {
  const World world = OneBall();
  const auto off = [&](double h) {
    return FreeFlight(world, [h](double t) { return Eigen::Vector3d(3 * h * t, h, 0); });
  };
  const Trajectory limit = ExtrapolatedToZeroStep(off(0.02), off(0.01));
  EXPECT_LE(DistanceBetween(limit, FreeFlight(world), 1, kEver), 1e-14);
}

}  // namespace
}  // namespace touchstone
