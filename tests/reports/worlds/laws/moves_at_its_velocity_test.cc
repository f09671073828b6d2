#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

const Claim kClaim = ClaimOf("moves_at_its_velocity");

/** A box in free flight that spins about its principal axis y. */
World SpinningBox(double spin = 3) {
  World world;
  world.bodies = {BodyOf("box", Box{{0.2, 0.3, 0.1}}, 2, {1, 5, 0})};
  world.bodies[0].v_WB = {2, 1, 0};
  world.bodies[0].w_WB = {0, spin, 0};
  world.dt = 0.01;
  world.steps = 40;
  return world;
}

/** Returns a flight that moves by (1 − `late`) of the velocity at the start of each step
 and `late` of that at its end. */
Trajectory Flown(const World& world, double late) {
  return Stepped(world, [&world, late](WorldState& state) {
    BodyState& body = state.bodies[0];
    const Vector3d next = body.v_WB + world.dt * world.gravity_W;
    body.p_WB += world.dt * ((1 - late) * body.v_WB + late * next);
    body.v_WB = next;
    body.q_WB = Turned(body.q_WB, world.dt * body.w_WB);
  });
}

TEST(MovesAtItsVelocity, AFlightPassesAtTheVelocityOfAnyMomentOfItsSteps) {
  const World world = SpinningBox();
  for (const double late : {0.0, 0.5, 0.9, 1.0})
    EXPECT_TRUE(Passes(Judge(world, Flown(world, late), kClaim))) << late;
  EXPECT_TRUE(
      Finds(Judge(world, Flown(world, 1.001), kClaim), MeasureKind::kTravelError));
  EXPECT_TRUE(
      Finds(Judge(world, Flown(world, -0.001), kClaim), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, FindsABodyThatStaysWhereItIs) {
  const World world = SpinningBox();
  Trajectory still = Flown(world, 1);
  for (WorldState& state : still.samples)
    state.bodies[0].p_WB = still.samples[0].bodies[0].p_WB;
  EXPECT_TRUE(Finds(Judge(world, still, kClaim), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, FindsABodyThatNeverTurns) {
  for (const double spin : {1e-6, 3.0, 100.0}) {
    const World world = SpinningBox(spin);
    Trajectory still = Flown(world, 1);
    for (WorldState& state : still.samples)
      state.bodies[0].q_WB = still.samples[0].bodies[0].q_WB;
    EXPECT_TRUE(Finds(Judge(world, still, kClaim), MeasureKind::kTurnError)) << spin;
  }
}

TEST(TurnsOnce, moves_at_its_velocity) {
  // The step is short: two samples do not tell a spin of more than half a turn a step.
  World world = SpinningBox();
  world.dt = 1e-5;
  EXPECT_TRUE(TurnsOnce(world, Flown(world, 1), kClaim));
}

TEST(MovesAtItsVelocity, AQuaternionThatIsExtendedAlongItsTangentPasses) {
  const World world = SpinningBox(60);  // 0.6 rad a step.
  const auto turned_by = [&](double share) {
    return Judge(world,
                 Stepped(world,
                         [&](WorldState& state) {
                           BodyState& body = state.bodies[0];
                           body.v_WB += world.dt * world.gravity_W;
                           body.p_WB += world.dt * body.v_WB;
                           const Vector3d half = world.dt / 2 * body.w_WB;
                           Eigen::Quaterniond rate(0, share * half.x(), share * half.y(),
                                                   share * half.z());
                           rate = rate * body.q_WB;
                           body.q_WB.coeffs() += rate.coeffs();
                           body.q_WB.normalize();
                         }),
                 kClaim);
  };
  EXPECT_TRUE(Passes(turned_by(1)));
  EXPECT_TRUE(Finds(turned_by(1.2), MeasureKind::kTurnError));
}

TEST(MovesAtItsVelocity, AStepMayTurnABodyMoreThanOnce) {
  // 7 rad a step look like 0.72 rad.
  const World world = SpinningBox(700);
  EXPECT_TRUE(Passes(Judge(world, Flown(world, 1), kClaim)));
}

/** Returns the motion of a ball at `v`, in weightlessness, whose velocity is `after` from
 step 3 on, and which moves by `way` in that step. */
Trajectory Struck(const World& world, const Vector3d& v, const Vector3d& after,
                  const Vector3d& way) {
  Trajectory struck = Sampled(world, [&](double) { return StateAtStart(world); });
  Vector3d p_W = struck.samples[0].bodies[0].p_WB;
  for (std::size_t s = 0; s < struck.samples.size(); ++s) {
    BodyState& ball = struck.samples[s].bodies[0];
    if (s > 0) p_W += s == 3 ? way : Vector3d(world.dt * (s < 3 ? v : after));
    ball.p_WB = p_W;
    ball.v_WB = s < 3 ? v : after;
  }
  struck.gives_impulses = true;
  return struck;
}

World BallWithoutWeight() {
  World world;
  world.bodies = {BodyOf("ball", Sphere{0.1}, 2, {0, 0, 0})};
  world.gravity_W.setZero();
  world.dt = 0.01;
  world.steps = 6;
  return world;
}

TEST(MovesAtItsVelocity, AnImpactMayFallAnywhereWithinItsStep) {
  const World world = BallWithoutWeight();
  for (const double way : {-0.005, 0.0, 0.01}) {
    EXPECT_TRUE(
        Passes(Judge(world, Struck(world, {1, 0, 0}, {-0.5, 0, 0}, {way, 0, 0}), kClaim)))
        << way;
  }
  for (const double way : {-0.0051, 0.0101}) {
    EXPECT_TRUE(
        Finds(Judge(world, Struck(world, {1, 0, 0}, {-0.5, 0, 0}, {way, 0, 0}), kClaim),
              MeasureKind::kTravelError))
        << way;
  }
}

TEST(MovesAtItsVelocity, TwoImpactsInAStepPassIfTheirContactsAreReported) {
  const World world = BallWithoutWeight();
  // From wall to wall and on: 1 m/s before and after, but −1 m/s for half of the step.
  Trajectory twice = Struck(world, {1, 0, 0}, {1, 0, 0}, {0, 0, 0});
  EXPECT_TRUE(Finds(Judge(world, twice, kClaim), MeasureKind::kTravelError));
  const double J = 2 * world.bodies[0].mass;
  for (const double sign : {-1.0, 1.0})
    twice.impulses.push_back({3, 0, 0, {0, 0, 0}, {1, 0, 0}, {sign * J, 0, 0}, 0});
  EXPECT_TRUE(Passes(Judge(world, twice, kClaim)));
  // Not even two impacts take it back.
  const Trajectory back = Struck(world, {1, 0, 0}, {1, 0, 0}, {-0.0101, 0, 0});
  EXPECT_TRUE(Finds(Judge(world, back, kClaim), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, ContactsThatNobodyReportsGrantSomeOnlyWhereTheyMayBe) {
  World world = BallWithoutWeight();
  world.gravity_W = {0, -1, 0};
  world.bodies[0].placed.X_WB.p_WB = {0, 0.1, 0};
  // It lies on the ground, and one evaluation of its contact lifts it by g h².
  const auto lifted_by = [&](double share) {
    Trajectory motion = Sampled(world, [&](double) { return StateAtStart(world); });
    for (std::size_t s = 3; s < motion.samples.size(); ++s)
      motion.samples[s].bodies[0].p_WB.y() += share * world.dt * world.dt;
    return motion;
  };
  EXPECT_TRUE(Finds(Judge(world, lifted_by(1.2), kClaim), MeasureKind::kTravelError));
  world.bodies.push_back(GroundOf());
  EXPECT_TRUE(Passes(Judge(world, lifted_by(1.2), kClaim)));
  EXPECT_TRUE(Finds(Judge(world, lifted_by(5), kClaim), MeasureKind::kTravelError));
}

/** A ball at rest that is `depth` deep in the ground, without weight. */
World BallInGround(double depth) {
  World world = BallWithoutWeight();
  world.bodies[0].placed.X_WB.p_WB = {0, 0.1 - depth, 0};
  world.bodies.push_back(GroundOf());
  return world;
}

TEST(MovesAtItsVelocity, ACorrectionMovesABodyByNoMoreThanItsDepth) {
  const World world = BallInGround(0.003);
  EXPECT_TRUE(
      Passes(Judge(world, Struck(world, {0, 0, 0}, {0, 0, 0}, {0, 0.003, 0}), kClaim)));
  EXPECT_TRUE(
      Finds(Judge(world, Struck(world, {0, 0, 0}, {0, 0, 0}, {0, 0.0031, 0}), kClaim),
            MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, ACorrectionUndoesTheOverlapThatItsStepMakes) {
  World world = BallWithoutWeight();
  world.bodies[0].placed.X_WB.p_WB = {0, 0.1, 0};
  world.bodies[0].v_WB = {1, -0.5, 0};
  world.bodies.push_back(GroundOf());
  // It strikes the ground, slides on, and is lifted from where −0.5 m/s have taken it.
  const auto lifted_by = [&](double way) {
    Trajectory motion = Sampled(world, [&](double t) {
      WorldState state = StateAtStart(world);
      BodyState& ball = state.bodies[0];
      ball.p_WB += Vector3d(t, t > 0 ? way - 0.005 : 0, 0);
      if (t > 0) ball.v_WB = {1, 0, 0};
      return state;
    });
    motion.gives_impulses = true;
    motion.impulses = {{1, 0, 1, {0, 0, 0}, {0, -1, 0}, {0, -1, 0}, 0}};
    return Judge(world, motion, kClaim);
  };
  for (const double way : {0.0, 0.005, 0.0099})
    EXPECT_TRUE(Passes(lifted_by(way))) << way;
  EXPECT_TRUE(Finds(lifted_by(0.0151), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, ACorrectionMovesAllBodiesThatOverlapsLink) {
  World world = BallInGround(0.003);
  std::swap(world.bodies[0], world.bodies[1]);
  world.bodies.insert(world.bodies.begin(),
                      BodyOf("upper", Sphere{0.1}, 1, {0, 0.1 - 0.003 + 0.2 - 0.001, 0}));
  world.bodies.push_back(BodyOf("far", Sphere{0.1}, 1, {5, 1, 0}));
  const auto upper = [&](double way) {
    return Judge(world, Struck(world, {0, 0, 0}, {0, 0, 0}, {0, way, 0}), kClaim);
  };
  EXPECT_TRUE(Passes(upper(0.004)));
  EXPECT_TRUE(Finds(upper(0.0041), MeasureKind::kTravelError));
  // An overlap of other bodies grants nothing to this one.
  std::swap(world.bodies[0], world.bodies[3]);
  EXPECT_TRUE(Finds(upper(1e-6), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, ACorrectionTurnsABodyByNoMoreThanItsDepthOverTheGyration) {
  World world = BallInGround(0.003);
  const double k = std::sqrt(0.4) * 0.1;
  const auto turned_by = [&](double angle) {
    Trajectory motion = Sampled(world, [&](double) { return StateAtStart(world); });
    for (std::size_t s = 3; s < motion.samples.size(); ++s)
      motion.samples[s].bodies[0].q_WB =
          Turned(Eigen::Quaterniond::Identity(), {0, 0, angle});
    return Judge(world, motion, kClaim);
  };
  EXPECT_TRUE(Passes(turned_by(0.999 * 0.003 / (2 * k))));
  EXPECT_TRUE(Finds(turned_by(1.001 * 0.003 / (2 * k)), MeasureKind::kTurnError));
}

/** A bob that swings around the origin at 8 rad/s, and states `share` of its velocity. */
std::vector<LawFinding> Swung(double h, double share) {
  World world;
  world.particles = {{"bob", {1, 0, 0}, {0, 8, 0}, 1}};
  world.joints = {{{AnchorKind::kParticle, 0, {0, 0, 0}}, {}, 1}};
  world.gravity_W.setZero();
  world.dt = h;
  world.steps = 20;
  const auto at = [&](double t) {
    WorldState state = StateAtStart(world);
    state.particles[0] = {{std::cos(8 * t), std::sin(8 * t), 0},
                          share * Vector3d(-8 * std::sin(8 * t), 8 * std::cos(8 * t), 0)};
    return state;
  };
  return Judge(world, Sampled(world, at), kClaim);
}

TEST(MovesAtItsVelocity, ASwingOnARodTurnsItsVelocityWithinTheStep) {
  for (const double h : {0.005, 0.05, 0.2}) EXPECT_TRUE(Passes(Swung(h, 1))) << h;
  for (const double share : {-1.0, 0.5, 3.0})
    EXPECT_TRUE(Finds(Swung(0.005, share), MeasureKind::kTravelError)) << share;
}

/** Returns the motion of two weightless bobs on a rod of 1 m, of 1 kg and of `mass`,
 which rest before and after a step in which the first moves by `way`. */
std::vector<LawFinding> MovedOnce(double mass, double speed, double way) {
  World world;
  world.particles = {{"light", {0, 0, 0}, {0, 0, 0}, 1},
                     {"heavy", {1, 0, 0}, {0, speed, 0}, mass}};
  world.joints = {
      {{AnchorKind::kParticle, 0, {0, 0, 0}}, {AnchorKind::kParticle, 1, {0, 0, 0}}, 1}};
  world.gravity_W.setZero();
  world.dt = 0.01;
  world.steps = 4;
  int done = 0;
  const auto step = [&](WorldState& state) {
    state.particles[1].p_W += world.dt * state.particles[1].v_W;
    if (++done == 2) state.particles[0].p_W.z() += way;
  };
  return Judge(world, Stepped(world, step), ClaimOf("moves_at_its_velocity", {"light"}));
}

TEST(MovesAtItsVelocity, AHeavyBodyOnARodMayShakeALightOneWithinAStep) {
  // 2 E/(m L) of 2 E = 100 J, in 0.01 s four times, and half of it to and fro: 2 cm.
  EXPECT_TRUE(Passes(MovedOnce(100, 1, 0.0199)));
  EXPECT_TRUE(Finds(MovedOnce(100, 1, 0.025), MeasureKind::kTravelError));
  EXPECT_TRUE(Finds(MovedOnce(100, 0.01, 0.0199), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, ARodThatStartsTooLongMayBeCorrectedAtOnce) {
  World world;
  world.particles = {{"bob", {1.01, 0, 0}, {0, 0, 0}, 1}};
  world.joints = {{{AnchorKind::kParticle, 0, {0, 0, 0}}, {}, 1}};
  world.gravity_W.setZero();
  world.steps = 5;
  const auto shortened_by = [&](double length) {
    Trajectory motion = Sampled(world, [&](double) { return StateAtStart(world); });
    for (std::size_t s = 1; s < motion.samples.size(); ++s)
      motion.samples[s].particles[0].p_W.x() -= length;
    return Judge(world, motion, kClaim);
  };
  EXPECT_TRUE(Passes(shortened_by(0.01)));
  EXPECT_TRUE(Finds(shortened_by(0.0101), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, FindsAParticleAndANodeThatStayWhereTheyAre) {
  World world;
  world.particles = {{"pellet", {0, 1, 0}, {2, 0, 0}, 1}};
  world.gravity_W.setZero();
  world.steps = 5;
  const auto still = [&] {
    return Sampled(world, [&](double) { return StateAtStart(world); });
  };
  EXPECT_TRUE(Finds(Judge(world, still(), kClaim), MeasureKind::kTravelError));
  world.particles.clear();
  world.cloths.resize(1);
  world.cloths[0].name = "sheet";
  Trajectory sheet = still();
  EXPECT_TRUE(Passes(Judge(world, sheet, kClaim)));
  for (WorldState& state : sheet.samples) state.nodes[4].v_W = {0, 2, 0};
  EXPECT_TRUE(Finds(Judge(world, sheet, kClaim), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, ACorrectionMovesAParticleByNoMoreThanItsDepth) {
  World world;
  world.bodies = {GroundOf()};
  world.particles = {{"pellet", {0, -0.002, 0}, {0, 0, 0}, 1}};
  world.gravity_W.setZero();
  world.steps = 5;
  const auto lifted_by = [&](double way) {
    Trajectory motion = Sampled(world, [&](double) { return StateAtStart(world); });
    for (std::size_t s = 1; s < motion.samples.size(); ++s)
      motion.samples[s].particles[0].p_W.y() += way;
    return Judge(world, motion, kClaim);
  };
  EXPECT_TRUE(Passes(lifted_by(0.002)));
  EXPECT_TRUE(Finds(lifted_by(0.0021), MeasureKind::kTravelError));
}

TEST(MovesAtItsVelocity, SaysWhereTheVelocitiesLead) {
  const World world = BallWithoutWeight();
  const std::vector<LawFinding> findings =
      Judge(world, Struck(world, {1, 0, 0}, {1, 0, 0}, {0.5, 0, 0}), kClaim);
  const LawFinding found = Of(findings, MeasureKind::kTravelError);
  EXPECT_NEAR(found.value, 0.49, 1e-12);
  EXPECT_THAT(found.proof,
              testing::HasSubstr("“ball” move by (0.5, 0, 0) in the step to 0.03 s; its "
                                 "velocities before and after move it by (0.01, 0, 0) "
                                 "and (0.01, 0, 0)"));
  EXPECT_THAT(found.cited.names, testing::ElementsAre("ball"));
}

}  // namespace
}  // namespace touchstone
