#include <cmath>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

BodyDefinition PointAt(const Eigen::Vector3d& p_W, const Eigen::Vector3d& v_W) {
  BodyDefinition point;
  point.shape = Point{};
  point.state.p_WB = p_W;
  point.state.v_WB = v_W;
  return point;
}

BodyDefinition StaticBox(const Eigen::Vector3d& half_extents,
                         const Eigen::Vector3d& p_W) {
  BodyDefinition box;
  box.shape = Box{half_extents};
  box.mass = 0;
  box.state.p_WB = p_W;
  return box;
}

TEST(Point, FallsWithDragLikeTheClosedForm) {
  const double c = 0.5;
  const double t = 2;
  for (const int steps : {1, 10, 120}) {
    World world;
    BodyDefinition dust = PointAt({0.4, 2.1, -0.3}, {3, 4, -1});
    dust.drag = c;
    dust.mass = 0.3;
    world.AddBody(dust);
    for (int k = 0; k < steps; ++k) world.Step(t / steps);
    // v' = g − c v.
    const Eigen::Vector3d v_end = world.settings().gravity_W / c;
    const Eigen::Vector3d excess = dust.state.v_WB - v_end;
    const double decay = std::exp(-c * t);
    const Eigen::Vector3d v = v_end + decay * excess;
    const Eigen::Vector3d p = dust.state.p_WB + t * v_end + (1 - decay) / c * excess;
    EXPECT_LT((world.state(0).v_WB - v).norm(), 1e-13) << steps;
    EXPECT_LT((world.state(0).p_WB - p).norm(), 1e-13) << steps;
  }
}

TEST(Point, BouncesAtItsTimeOfImpact) {
  // From the height H with the restitution e: the point lands at t = √(2H/g), and the
  // flight after the n-th bounce takes 2 eⁿ t.
  const double g = 9.82;
  const double height = 1.3;
  const double e = 0.7;
  World world;
  world.AddBody(StaticBox({2, 1, 2}, {0.1, -1, 0.2}));
  BodyDefinition ball = PointAt({0, height, 0}, {0.4, 0, 0});
  ball.restitution = e;
  const int point = world.AddBody(ball);
  const double fall = std::sqrt(2 * height / g);
  double since = 0;  // Time of the last bounce.
  double speed = 0;  // Speed after it.
  double next = fall;
  for (int k = 1; k <= 300; ++k) {
    world.Step(1.0 / 240);
    const double t = k / 240.0;
    while (next <= t) {
      speed = speed == 0 ? e * g * fall : e * speed;
      since = next;
      next += 2 * speed / g;
    }
    const double airborne = t - since;
    const double y = since == 0 ? height - 0.5 * g * t * t
                                : speed * airborne - 0.5 * g * airborne * airborne;
    // Rounding of the time of impact, times about 5 m/s, for a few bounces.
    EXPECT_NEAR(world.state(point).p_WB[1], y, 1e-13) << k;
    EXPECT_NEAR(world.state(point).p_WB[0], 0.4 * t, 1e-13) << k;
  }
}

TEST(Point, ComesToRestOnABoxAndStaysThere) {
  World world;
  world.AddBody(StaticBox({2, 1, 2}, {0, -1, 0}));
  BodyDefinition ball = PointAt({0, 0.5, 0}, {0, 0, 0});
  ball.restitution = 0.5;
  const int point = world.AddBody(ball);
  for (int k = 0; k < 1200; ++k) {
    world.Step(1.0 / 240);
    EXPECT_GE(world.state(point).p_WB[1], -1e-15);
  }
  EXPECT_EQ(world.state(point).v_WB[1], 0);
  EXPECT_NEAR(world.state(point).p_WB[1], 0, 1e-15);
}

TEST(Point, SlidesDownATiltedBoxWithoutFriction) {
  // The acceleration along the slope is g sin α for any time step.
  World world;
  BodyDefinition slope = StaticBox({5, 0.5, 5}, {0, 0, 0});
  slope.state.q_WB = Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitZ());
  world.AddBody(slope);
  const Eigen::Vector3d n = slope.state.q_WB * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d down = slope.state.q_WB * Eigen::Vector3d::UnitX();
  BodyDefinition bead = PointAt(0.5 * n, {0, 0, 0});
  bead.restitution = 0;
  const int point = world.AddBody(bead);
  for (int k = 0; k < 240; ++k) world.Step(1.0 / 240);
  const Eigen::Vector3d p = 0.5 * n + 0.5 * 9.82 * std::sin(0.4) * down;
  EXPECT_LT((world.state(point).p_WB - p).norm(), 1e-12);
}

TEST(Point, PassesSolidsThatItDoesNotHit) {
  World world;
  world.AddBody(StaticBox({1, 1, 1}, {0, 0, 0}));
  BodyDefinition ghost = StaticBox({1, 1, 1}, {5, 0, 0});
  ghost.collides = false;
  world.AddBody(ghost);
  const int past = world.AddBody(PointAt({1.01, 3, 0}, {0, -2, 0}));
  const int through = world.AddBody(PointAt({5, 3, 0}, {0, -2, 0}));
  const int out = world.AddBody(PointAt({0.2, 0, 0}, {0, -2, 0}));
  for (int k = 0; k < 240; ++k) world.Step(1.0 / 240);
  for (const int point : {past, through, out}) {
    const double fall = -2 - 0.5 * 9.82;
    EXPECT_NEAR(world.state(point).p_WB[1], (point == out ? 0 : 3) + fall, 1e-13);
  }
}

TEST(Point, BouncesAtAnySpeed) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  world.AddBody(StaticBox({0.01, 1, 1}, {0, 0, 0}));
  BodyDefinition bullet = PointAt({-3, 0.1, 0.2}, {900, 0, 0});
  bullet.restitution = 1;
  const int point = world.AddBody(bullet);
  world.Step(1.0 / 240);
  EXPECT_NEAR(world.state(point).v_WB[0], -900, 1e-12);
  // 3.75 m in total, 2.99 m of it to the wall.
  EXPECT_NEAR(world.state(point).p_WB[0], -0.01 - 0.76, 1e-12);
}

TEST(Point, RefusesANegativeDragAndTheDragOfABox) {
  World world;
  BodyDefinition point = PointAt({0, 0, 0}, {0, 0, 0});
  point.drag = -1;
  EXPECT_THROW(world.AddBody(point), std::invalid_argument);
  BodyDefinition box;
  box.shape = Box{{1, 1, 1}};
  box.drag = 1;
  EXPECT_THROW(world.AddBody(box), std::invalid_argument);
  EXPECT_EQ(world.body_count(), 0);
}

}  // namespace
}  // namespace cookbook
