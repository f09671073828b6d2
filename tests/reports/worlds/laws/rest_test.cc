#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/sliding.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kG = 9.82;

/** Three boxes on the ground, 5, 2 and 1 kg. */
World Stack() {
  World world;
  double y = 0;
  for (const double mass : {5.0, 2.0, 1.0}) {
    world.bodies.push_back(BodyOf("level" + std::to_string(world.bodies.size()),
                                  Box{{0.3, 0.1, 0.3}}, mass, {0.2, y + 0.1, 0.1}));
    y += 0.2;
  }
  world.bodies.push_back(GroundOf());
  world.gravity_W = {0, -kG, 0};
  world.steps = 480;
  return world;
}

/** A stack at rest whose contacts carry the weight above them. The middle contact lacks
 the fraction `slack` of it, and the top moves sideways at the speed `creep`. */
Trajectory Standing(const World& world, double slack = 0, double creep = 0) {
  Trajectory trajectory = Stepped(world, [&](WorldState& state) {
    for (std::size_t i = 0; i < 3; ++i) {
      state.bodies[i].v_WB = {i == 2 ? creep : 0, 0, 0};
      state.bodies[i].p_WB += world.dt * state.bodies[i].v_WB;
    }
  });
  trajectory.gives_impulses = true;
  for (int step = 1; step <= world.steps; ++step) {
    double above = 0;
    for (int level = 2; level >= 0; --level) {
      above += world.bodies[static_cast<std::size_t>(level)].mass;
      const double J = above * kG * world.dt * (level == 1 ? 1 - slack : 1);
      const int below = level == 0 ? 3 : level - 1;
      // The lower body is B in the middle contact and A in the others.
      trajectory.impulses.push_back(
          level == 1
              ? ContactImpulse{step, level, below, {0, 0, 0}, {0, -1, 0}, {0, -J, 0}, 0}
              : ContactImpulse{step, below, level, {0, 0, 0}, {0, 1, 0}, {0, J, 0}, 0});
    }
  }
  return trajectory;
}

TEST(Rests, AStackAtRestPassesAndACreepingOneDoesNot) {
  const World world = Stack();
  EXPECT_TRUE(Passes(Judge(world, Standing(world), ClaimOf("rests"))));
  EXPECT_TRUE(Finds(Judge(world, Standing(world, 0, 2e-3), ClaimOf("rests")),
                    MeasureKind::kRestMotion));
}

TEST(Rests, AllowsTheFallBeforeALateContact) {
  const World world = Stack();
  const Trajectory settled = Sampled(world, [&](double t) {
    WorldState state;
    for (std::size_t i = 0; i < 4; ++i) {
      const Body& placed = world.bodies[i].placed;
      const double fallen = i < 3 && t > 0 ? kG * world.dt * world.dt : 0;
      state.bodies.push_back({placed.X_WB.p_WB - Eigen::Vector3d(0, fallen, 0),
                              placed.X_WB.q_WB.value(),
                              {0, 0, 0},
                              {0, 0, 0}});
    }
    return state;
  });
  EXPECT_TRUE(Passes(Judge(world, settled, ClaimOf("rests"))));
}

TEST(Rests, MayBeginLaterAndFindsRotation) {
  const World world = Stack();
  Trajectory falls_then_stands = Standing(world);
  for (std::size_t s = 0; s < 200; ++s)
    falls_then_stands.samples[s].bodies[2].p_WB.y() += 1;
  EXPECT_TRUE(
      Finds(Judge(world, falls_then_stands, ClaimOf("rests")), MeasureKind::kRestMotion));
  EXPECT_TRUE(Passes(
      Judge(world, falls_then_stands, ClaimOf("rests", {}, {{"from", 200 * world.dt}}))));
  Trajectory turns = Standing(world);
  turns.samples.back().bodies[1].q_WB = Eigen::AngleAxisd(0.03, Eigen::Vector3d::UnitY());
  EXPECT_TRUE(Finds(Judge(world, turns, ClaimOf("rests")), MeasureKind::kRestMotion));
  EXPECT_EQ(FaultsOf(world, ClaimOf("rests", {}, {{"from", 2}})).size(), 1U);
}

/** A ball that rests on the ground; two more, far away, start with an `overlap`. */
World RestsBesideAHeap(double overlap) {
  World world;
  world.bodies = {BodyOf("still", Sphere{0.2}, 1, {0, 0.2, 0}),
                  BodyOf("left", Sphere{0.2}, 1, {5, 0.2, 0}),
                  BodyOf("right", Sphere{0.2}, 1, {5.4 - overlap, 0.2, 0}), GroundOf()};
  world.dt = 1e-3;
  world.steps = 200;
  return world;
}

/** Moves `body` by 0.01 m along x from `from` [s] to `to` [s]. */
Trajectory Creeping(const World& world, std::size_t body, double from, double to) {
  return Sampled(world, [&world, body, from, to](double t) {
    WorldState state = StateAtStart(world);
    state.bodies[body].p_WB.x() += 0.01 * std::clamp((t - from) / (to - from), 0.0, 1.0);
    if (from < t && t < to) state.bodies[body].v_WB.x() = 0.01 / (to - from);
    return state;
  });
}

TEST(Rests, IsNotExcusedByAnOverlapElsewhere) {
  const World world = RestsBesideAHeap(0.01);
  EXPECT_TRUE(
      Finds(Judge(world, Creeping(world, 0, 0.1, 0.15), ClaimOf("rests", {"still"})),
            MeasureKind::kRestMotion));
}

TEST(Rests, GrantsOverlapsUntilTheyAreResolved) {
  const World world = RestsBesideAHeap(0.01);
  EXPECT_TRUE(Passes(
      Judge(world, Creeping(world, 2, 0, 0.05), ClaimOf("rests", {"left", "right"}))));
  const World touching = RestsBesideAHeap(0.001);
  // The overlap is resolved after a tenth of the motion.
  EXPECT_TRUE(Finds(Judge(touching, Creeping(touching, 2, 0, 0.05),
                          ClaimOf("rests", {"left", "right"})),
                    MeasureKind::kRestMotion));
}

TEST(StackSupport, TheFullWeightPassesAndAPartOfItDoesNot) {
  const World world = Stack();
  const Claim claim = ClaimOf("stack_support", {}, {{"expected_weight", 8 * kG}});
  EXPECT_TRUE(Passes(Judge(world, Standing(world), claim)));
  const LawFinding finding =
      Of(Judge(world, Standing(world, 0.1), claim), MeasureKind::kForceError);
  EXPECT_GT(finding.value, finding.tolerance.value);
  EXPECT_NEAR(finding.value, 0.1 * 3 * kG, 1e-9);
}

TEST(StackSupport, RefusesAnotherOrderAndJudgesNoEngineWithoutImpulses) {
  const World world = Stack();
  EXPECT_EQ(FaultsOf(world, ClaimOf("stack_support", {"level1", "level0"})).size(), 1U);
  Trajectory silent = Standing(world);
  silent.gives_impulses = false;
  EXPECT_TRUE(Judge(world, silent, ClaimOf("stack_support")).empty());
}

TEST(MomentumBalance, AStackAtRestPassesAndAWrongImpulseIsFound) {
  const World world = Stack();
  EXPECT_TRUE(Passes(Judge(world, Standing(world), ClaimOf("momentum_balance"))));
  EXPECT_TRUE(Finds(Judge(world, Standing(world, 1e-6), ClaimOf("momentum_balance")),
                    MeasureKind::kMomentumBalance));
}

TEST(MomentumBalance, CountsForcesPushesAndStepsBetweenSamples) {
  World world;
  world.bodies = {BodyOf("ball", Sphere{0.2}, 2, {0, 1, 0})};
  world.bodies[0].force_W = {1, 0, 3};
  world.pushes.push_back({0, 5 * world.dt, {0, 0.1, 0}, {0.4, -1, 2}});
  for (const int sample_every : {1, 3}) {
    world.sample_every = sample_every;
    int step = 0;
    const Trajectory moved = [&] {
      Trajectory trajectory = Stepped(world, [&](WorldState& state) {
        BodyState& is = state.bodies[0];
        is.v_WB += world.dt * (world.gravity_W + world.bodies[0].force_W / 2);
        if (step++ == 5) is.v_WB += world.pushes[0].J_W / 2;
        is.p_WB += world.dt * is.v_WB;
      });
      trajectory.gives_impulses = true;
      return trajectory;
    }();
    EXPECT_TRUE(Passes(Judge(world, moved, ClaimOf("momentum_balance")))) << sample_every;
    World weak = world;
    weak.pushes[0].J_W.x() += 1e-6;
    EXPECT_TRUE(Finds(Judge(weak, moved, ClaimOf("momentum_balance")),
                      MeasureKind::kMomentumBalance));
  }
}

/** One contact of a 1 kg ball on the ground with μ = 0.5 in each step: J_n = 2 N s and
 the tangential impulse `J_t`. */
Trajectory Rubbing(const World& world, const Eigen::Vector2d& J_t) {
  Trajectory trajectory = Sampled(world, [](double) { return WorldState{}; });
  trajectory.gives_impulses = true;
  for (int step = 1; step <= world.steps; ++step) {
    trajectory.impulses.push_back(
        {step, 1, 0, {0, 0, 0}, {0, 1, 0}, {J_t.x(), 2, J_t.y()}, 0});
  }
  return trajectory;
}

TEST(CoulombCone, TheCirclePassesAndTheBoxIsRecognised) {
  const World world = BallOnRoughGround();
  const double angle = 0.6;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  EXPECT_TRUE(Passes(Judge(world, Rubbing(world, along), ClaimOf("coulomb_cone"))));
  const LawFinding box =
      Of(Judge(world, Rubbing(world, {1, 0.8}), ClaimOf("coulomb_cone")),
         MeasureKind::kConeViolation);
  EXPECT_NEAR(box.value, std::hypot(1, 0.8) - 1, 1e-12);
  EXPECT_EQ(box.recognised, "L∞ friction cone");
  EXPECT_TRUE(Finds(Judge(world, Rubbing(world, {1.001, 0}), ClaimOf("coulomb_cone")),
                    MeasureKind::kConeViolation));
}

TEST(CoulombCone, FindsTooLargeFrictionInsideTheBoxCone) {
  // μ J_n = 1 N s; the magnitude is 1.27, the larger component 0.9.
  const World world = BallOnRoughGround();
  EXPECT_TRUE(Finds(Judge(world, Rubbing(world, {0.9, 0.9}), ClaimOf("coulomb_cone")),
                    MeasureKind::kConeViolation));
}

TEST(CoulombCone, FindsANaNImpulseAtAnyStep) {
  const World world = BallOnRoughGround();
  for (const std::size_t at : {0U, 4U, 9U}) {
    Trajectory trajectory = Rubbing(world, {0.5, 0});
    trajectory.impulses[at].J_B_W.y() = std::nan("");
    EXPECT_TRUE(Finds(Judge(world, trajectory, ClaimOf("coulomb_cone")),
                      MeasureKind::kConeViolation))
        << at;
  }
}

TEST(CoulombCone, UsesOneFrameForAMotion) {
  // On a slope the directions from the x axis and from the y axis differ: the impulse is
  // at the corner of one box, then of the other.
  const World world = BallOnRoughGround();
  const Eigen::Vector3d n_W = Eigen::Vector3d(0.5, 0.6, 0.4).normalized();
  const auto rubbing = [&](int first_axis, int second_axis) {
    Trajectory trajectory = Rubbing(world, {0, 0});
    for (ContactImpulse& contact : trajectory.impulses) {
      const TangentFrame frame =
          *TangentFrameAlong(n_W, contact.step % 2 == 0 ? first_axis : second_axis);
      contact.n_AB_W = n_W;
      contact.J_B_W = 2 * n_W + frame * Eigen::Vector2d(1, 1);
    }
    return Of(Judge(world, trajectory, ClaimOf("coulomb_cone")),
              MeasureKind::kConeViolation)
        .recognised;
  };
  EXPECT_EQ(rubbing(0, 0), "L∞ friction cone");
  EXPECT_EQ(rubbing(1, 1), "L∞ friction cone");
  EXPECT_EQ(rubbing(0, 1), "");
}

TEST(CoulombCone, RecognisesABoxThatTurnsWithTheSlipIfTheEngineStatesItsDirections) {
  // The impulse is at the corner of a box that turns from step to step.
  const World world = BallOnRoughGround();
  const auto rubbing = [&](double stated_off, double stated_length) {
    Trajectory trajectory = Rubbing(world, {0, 0});
    for (ContactImpulse& contact : trajectory.impulses) {
      const auto along = [&](double angle) {
        return Eigen::Vector3d(std::cos(angle), 0, std::sin(angle));
      };
      const double angle = 0.3 * contact.step;
      contact.J_B_W =
          2 * contact.n_AB_W + along(angle) + contact.n_AB_W.cross(along(angle));
      contact.t_W = stated_length * along(angle + stated_off);
    }
    return Of(Judge(world, trajectory, ClaimOf("coulomb_cone")),
              MeasureKind::kConeViolation)
        .recognised;
  };
  EXPECT_EQ(rubbing(0, 1), "L∞ friction cone");
  EXPECT_EQ(rubbing(0.3, 1), "");  // Then it is outside the box that is stated.
  EXPECT_EQ(rubbing(0, 0.9), "");  // A short direction would shrink the impulse.
  EXPECT_EQ(rubbing(0, 0), "");    // Without a statement, no fixed directions fit.
}

TEST(CoulombCone, JudgesAnEngineThatShowsItsBoxByThatBox) {
  // At the corner of the box the friction is 0.41 N s beyond the circle. One contact
  // keeps a friction of 0.3 N s without a normal impulse.
  const World world = BallOnRoughGround();
  Trajectory trajectory = Rubbing(world, {0, 0});
  for (ContactImpulse& contact : trajectory.impulses) {
    contact.t_W = Eigen::Vector3d::UnitX();
    contact.J_B_W = 2 * contact.n_AB_W + contact.t_W + contact.n_AB_W.cross(contact.t_W);
  }
  trajectory.impulses[5].J_B_W = 0.3 * trajectory.impulses[5].t_W;
  const LawFinding finding =
      Of(Judge(world, trajectory, ClaimOf("coulomb_cone")), MeasureKind::kConeViolation);
  EXPECT_NEAR(finding.value, 0.3, 1e-12);
  EXPECT_EQ(finding.recognised, "");
  EXPECT_THAT(finding.proof, testing::HasSubstr("shows the L∞ friction cone, but gives"));
}

TEST(CoulombCone, FindsAContactThatPulls) {
  const World world = BallOnRoughGround();
  Trajectory pulling = Rubbing(world, {0, 0});
  pulling.impulses[3].J_B_W.y() = -0.1;
  const LawFinding finding =
      Of(Judge(world, pulling, ClaimOf("coulomb_cone")), MeasureKind::kConeViolation);
  EXPECT_NEAR(finding.value, 0.1, 1e-12);
  EXPECT_TRUE(finding.recognised.empty());
}

/** Two balls and the ground, at rest, each `depth` deep in the one below. */
Trajectory Sunk(const World& world, double depth) {
  return Sampled(world, [&world, depth](double) {
    WorldState state;
    double y = 0;
    for (const RigidBody& body : world.bodies) {
      y += body.mass > 0 ? 0.1 - depth : 0;
      state.bodies.push_back(
          {body.mass > 0 ? Eigen::Vector3d(0, y, 0) : Eigen::Vector3d::Zero(),
           body.placed.X_WB.q_WB.value(),
           {0, 0, 0},
           {0, 0, 0}});
      y += body.mass > 0 ? 0.1 : 0;
    }
    return state;
  });
}

World Pile() {
  World world;
  world.bodies = {GroundOf(), BodyOf("low", Sphere{0.1}, 1, {0, 0.1, 0}),
                  BodyOf("high", Sphere{0.1}, 1, {0, 0.3, 0})};
  world.steps = 100;
  world.dt = 1e-3;
  return world;
}

TEST(PenetrationScore, IsTheRootOfTheMeanSumOfSquares) {
  const World world = Pile();
  const LawFinding finding =
      Of(Judge(world, Sunk(world, 1e-3), ClaimOf("penetration_score")),
         MeasureKind::kPenetration);
  EXPECT_NEAR(finding.value, std::sqrt(2) * 1e-3, 1e-12);
  // At rest a late contact may only leave g (Δt + h) h: 2 · 9.82e-6 m, × 1.5.
  EXPECT_NEAR(finding.tolerance.value, 1.5 * std::sqrt(2) * 2 * 9.82e-6, 1e-11);
  EXPECT_TRUE(Finds(Judge(world, Sunk(world, 1e-3), ClaimOf("penetration_score")),
                    MeasureKind::kPenetration));
  EXPECT_TRUE(Passes(Judge(world, Sunk(world, 1e-5), ClaimOf("penetration_score"))));
}

TEST(PenetrationScore, MayCiteAPublishedSlope) {
  const World world = Pile();
  const Claim claim = ClaimOf("penetration_score", {}, {{"slope", 155}});
  EXPECT_TRUE(Passes(Judge(world, Sunk(world, 1e-2), claim)));
  EXPECT_TRUE(Finds(Judge(world, Sunk(world, 1.5e-2), claim), MeasureKind::kPenetration));
}

TEST(TurnsOnce, rests) {
  const World world = Stack();
  EXPECT_TRUE(TurnsOnce(world, Standing(world), ClaimOf("rests")));
}

TEST(TurnsOnce, stack_support) {
  const World world = Stack();
  EXPECT_TRUE(TurnsOnce(world, Standing(world), ClaimOf("stack_support")));
}

TEST(TurnsOnce, momentum_balance) {
  const World world = Stack();
  EXPECT_TRUE(TurnsOnce(world, Standing(world), ClaimOf("momentum_balance")));
}

TEST(TurnsOnce, coulomb_cone) {
  const World world = BallOnRoughGround();
  EXPECT_TRUE(TurnsOnce(world, Rubbing(world, {0.8, 0.6}), ClaimOf("coulomb_cone"),
                        {0.8, 0, 0.6}));
}

TEST(TurnsOnce, penetration_score) {
  const World world = Pile();
  EXPECT_TRUE(TurnsOnce(world, Sunk(world, 1e-6), ClaimOf("penetration_score")));
}

TEST(MomentumBalance, GrantsEverySolverTheRoundingOfAMinimum) {
  const World world = Stack();
  EXPECT_TRUE(Passes(Judge(world, Standing(world, 1e-8), ClaimOf("momentum_balance"))));
  EXPECT_TRUE(Finds(Judge(world, Standing(world, 1e-7), ClaimOf("momentum_balance")),
                    MeasureKind::kMomentumBalance));
}

}  // namespace
}  // namespace touchstone
