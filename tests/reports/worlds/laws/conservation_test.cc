#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/impact_gain.h"
#include "reports/worlds/law_support/scheme_drift.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/impact.h"
#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

/** Two particles with a spring between them, rotating and oscillating, in gravity. */
World SpringPair(double damping = 0) {
  World world;
  world.particles = {{"a", {0, 0, 0}, {0.3, 2, 0.1}, 0.5},
                     {"b", {0.9, 0.4, -0.2}, {-0.2, 2.4, 1.1}, 1.5}};
  world.springs = {{{AnchorKind::kParticle, 0, {0, 0, 0}},
                    {AnchorKind::kParticle, 1, {0, 0, 0}},
                    40,
                    damping,
                    0.8}};
  world.dt = 1e-3;
  world.steps = 2000;
  return world;
}

/** Semi-implicit Euler; the force on b is −`back` times the force on a. */
Trajectory Swung(const World& world, double back = 1, bool signless = false) {
  return Stepped(world, [&world, back, signless](WorldState& state) {
    const Spring& spring = world.springs[0];
    PointState& a = state.particles[0];
    PointState& b = state.particles[1];
    const Eigen::Vector3d p_AB = b.p_W - a.p_W;
    const Eigen::Vector3d u = p_AB.normalized();
    const double rate = signless ? (b.v_W - a.v_W).norm() : u.dot(b.v_W - a.v_W);
    const Eigen::Vector3d F =
        (spring.stiffness * (p_AB.norm() - spring.rest_length) + spring.damping * rate) *
        u;
    a.v_W += world.dt * (world.gravity_W + F / world.particles[0].mass);
    b.v_W += world.dt * (world.gravity_W - back * F / world.particles[1].mass);
    a.p_W += world.dt * a.v_W;
    b.p_W += world.dt * b.v_W;
  });
}

TEST(ConservesMomentum, ASpringInGravityPassesToRounding) {
  const World world = SpringPair();
  const std::vector<LawFinding> findings =
      Judge(world, Swung(world), ClaimOf("conserves_momentum"));
  EXPECT_TRUE(Passes(findings));
  EXPECT_LE(findings[0].tolerance.value, 1e-9);
}

TEST(ConservesMomentum, FindsAForceWithoutAnEqualReaction) {
  const World world = SpringPair();
  EXPECT_TRUE(Finds(Judge(world, Swung(world, 1.0001), ClaimOf("conserves_momentum")),
                    MeasureKind::kMomentumDrift));
}

TEST(ConservesMomentum, JudgesOnlyTheGivenDirection) {
  // The false gravity has no component along x, but one along y.
  World world = SpringPair();
  World heavy = world;
  heavy.gravity_W *= 1.1;
  const Trajectory fell = Swung(heavy);
  EXPECT_TRUE(Passes(Judge(world, fell, ClaimOf("conserves_momentum", {}, {{"x", 1}}))));
  EXPECT_TRUE(Finds(Judge(world, fell, ClaimOf("conserves_momentum", {}, {{"y", 1}})),
                    MeasureKind::kMomentumDrift));
}

TEST(ConservesMomentum, RefusesOneEndOfASpring) {
  EXPECT_EQ(FaultsOf(SpringPair(), ClaimOf("conserves_momentum", {"a"})).size(), 1U);
}

TEST(ConservesMomentum, KnowsTheMomentumAtTheStart) {
  const World world = SpringPair();
  const double P = (0.5 * world.particles[0].v_W + 1.5 * world.particles[1].v_W).norm();
  EXPECT_TRUE(
      FaultsOf(world, ClaimOf("conserves_momentum", {}, {{"expected_momentum", P}}))
          .empty());
  EXPECT_FALSE(FaultsOf(world, ClaimOf("conserves_momentum", {},
                                       {{"expected_momentum", P * 1.01}}))
                   .empty());
}

TEST(ConservesAngularMomentum, ASpringPassesToRounding) {
  const World world = SpringPair(0.7);
  const std::vector<LawFinding> findings =
      Judge(world, Swung(world), ClaimOf("conserves_angular_momentum"));
  EXPECT_TRUE(Passes(findings));
  EXPECT_LE(findings[0].tolerance.value, 1e-9);
}

/** A rod that spins about its own axis, which lies along no axis of the world. */
World SpinningRod() {
  World world;
  RigidBody rod = BodyOf("rod", Box{{0.66, 0.03, 0.04}}, 1, {0, 0, 0});
  rod.placed.X_WB = Pose::FromQuaternion(
      {0, 0, 0}, Eigen::Quaterniond(0.4, -0.2, 0.8, 0.4).normalized());
  rod.w_WB = 5 * rod.placed.X_WB.R_WB.col(0);
  world.bodies = {rod};
  world.dt = 1e-3;
  world.steps = 20;
  return world;
}

/** The rod turns at a constant spin. Its axis is `off` [rad] away from the spin. */
Trajectory Spun(const World& world, double off) {
  const RigidBody& rod = world.bodies[0];
  const Eigen::Vector3d across_W = off * rod.placed.X_WB.R_WB.col(1);
  return Stepped(world, [&world, across_W, first = true](WorldState& state) mutable {
    BodyState& at = state.bodies[0];
    if (std::exchange(first, false)) at.q_WB = Turned(at.q_WB, across_W);
    at.q_WB = Turned(at.q_WB, world.dt * at.w_WB);
  });
}

// One rounding of the orientation is 175 roundings of |R I Rᵀ ω|, since I_max is 175
// I_min.
TEST(ConservesAngularMomentum, GrantsARoundingOfTheAxisOfASpinningRod) {
  const World world = SpinningRod();
  const Claim claim = ClaimOf("conserves_angular_momentum");
  for (const double roundings : {0, 1, 10})
    EXPECT_TRUE(Passes(Judge(world, Spun(world, roundings * 0x1p-53), claim)));
  EXPECT_TRUE(
      Finds(Judge(world, Spun(world, 1e-9), claim), MeasureKind::kAngularMomentumDrift));
}

// Some 40 roundings: the axis (5), its quaternion (4) and its rotation (6), squared, and
// a sum. The matrix R I Rᵀ would have 10 of I_max, which are 1750 of this energy.
TEST(EnergyOf, ASpinAboutTheAxisOfARodHasItsOwnRoundingsOnly) {
  const World world = SpinningRod();
  const RigidBody& rod = world.bodies[0];
  const double exact = InertiaOf(rod).minCoeff() * 25 / 2;
  for (const WorldState& state : Spun(world, 0).samples) {
    const double energy = EnergyOf(world, state, {{0}, {}, {}}).total();
    EXPECT_NEAR(energy, exact, 40 * 0x1p-53 * exact);
  }
}

TEST(ConservesAngularMomentum, FindsAForceThatIsNotAlongTheSpring) {
  const World world = SpringPair();
  Trajectory tilted = Swung(world);
  for (std::size_t s = 0; s < tilted.samples.size(); ++s) {
    // A torque about x that conserves the momentum.
    const double kick = 1e-6 * static_cast<double>(s);
    tilted.samples[s].particles[0].v_W.y() += kick / 0.5;
    tilted.samples[s].particles[1].v_W.y() -= kick / 1.5;
  }
  EXPECT_TRUE(Finds(Judge(world, tilted, ClaimOf("conserves_angular_momentum")),
                    MeasureKind::kAngularMomentumDrift));
  EXPECT_TRUE(Passes(Judge(world, tilted, ClaimOf("conserves_momentum"))));
}

TEST(ConservesEnergy, ASpringPassesAtEveryStepSize) {
  for (const double dt : {1e-2, 1e-3, 1e-4}) {
    World world = SpringPair();
    world.dt = dt;
    world.steps = static_cast<int>(std::lround(2 / dt));
    EXPECT_TRUE(Passes(Judge(world, Swung(world), ClaimOf("conserves_energy")))) << dt;
  }
}

TEST(ConservesEnergy, InFreeFallIsOffByHalfMGHV) {
  World world;
  world.particles = {{"drop", {0, 0, 0}, {0, 0, 0}, 2}};
  const Trajectory fell = Stepped(world, [&](WorldState& state) {
    PointState& drop = state.particles[0];
    drop.v_W += world.dt * world.gravity_W;
    drop.p_W += world.dt * drop.v_W;
  });
  const LawFinding finding =
      Of(Judge(world, fell, ClaimOf("conserves_energy")), MeasureKind::kEnergyDrift);
  const double V = 9.82;
  EXPECT_NEAR(finding.value, 0.5 * 2 * 9.82 * V * world.dt, 1e-9);
  EXPECT_NEAR(finding.tolerance.value, 3 * finding.value, 0.03 * finding.value);
}

TEST(ConservesEnergy, FindsAPeriodThatDependsOnTheStep) {
  // Applies the spring's force as an impulse, without dt.
  World world = SpringPair();
  const Trajectory wrong = Stepped(world, [&](WorldState& state) {
    PointState& a = state.particles[0];
    PointState& b = state.particles[1];
    const Eigen::Vector3d p_AB = b.p_W - a.p_W;
    const Eigen::Vector3d J = 40e-3 * 1.2 * (p_AB.norm() - 0.8) * p_AB.normalized();
    a.v_W += world.dt * world.gravity_W + J / 0.5;
    b.v_W += world.dt * world.gravity_W - J / 1.5;
    a.p_W += world.dt * a.v_W;
    b.p_W += world.dt * b.v_W;
  });
  EXPECT_TRUE(
      Finds(Judge(world, wrong, ClaimOf("conserves_energy")), MeasureKind::kEnergyDrift));
}

TEST(ConservesEnergy, DoesNotMistakeAWrongStartForABounceRule) {
  World world;
  world.particles = {{"drop", {0, 3, 0}, {2, 0, 0}, 2}};
  for (const double g : {0.0, 9.82}) {
    world.gravity_W = {0, -g, 0};
    World faster = world;
    faster.particles[0].v_W *= 1.1;
    const Trajectory flew = Sampled(faster, [&](double t) {
      const Particle& drop = faster.particles[0];
      return WorldState{{},
                        {{drop.p_W + t * drop.v_W + 0.5 * t * t * world.gravity_W,
                          drop.v_W + t * world.gravity_W}},
                        {}};
    });
    EXPECT_TRUE(Finds(Judge(world, flew, ClaimOf("conserves_energy")),
                      MeasureKind::kEnergyDrift));
    EXPECT_TRUE(Finds(Judge(world, flew, ClaimOf("energy_never_rises")),
                      MeasureKind::kEnergyDrift));
  }
}

/** Returns a plank of 3 kg that tumbles freely, without gravity. */
World TumblingPlank() {
  World world;
  world.gravity_W.setZero();
  world.dt = 0.01;
  world.steps = 400;
  world.bodies = {BodyOf("plank", Box{{1, 0.2, 0.05}}, 3, {0, 0, 0})};
  world.bodies[0].w_WB = {3, 4, 1};
  return world;
}

// The drift of the gyroscopic term that adds up since the start is no excuse for a jump,
// and without gravity no rule reflects a velocity after it.
TEST(ConservesEnergy, RecognisesNoBounceRuleWhereNothingFalls) {
  const World world = TumblingPlank();
  const Trajectory stopped = Sampled(world, [&](double t) {
    const Eigen::Vector3d w_WB = t < 2 ? world.bodies[0].w_WB : Eigen::Vector3d::Zero();
    return WorldState{{{Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity(),
                        Eigen::Vector3d::Zero(), w_WB}},
                      {},
                      {}};
  });
  EXPECT_TRUE(Finds(Judge(world, stopped, ClaimOf("conserves_energy")),
                    MeasureKind::kEnergyDrift));
}

// Reflecting the velocity after gravity adds m g h v. Samples that are a quarter of the
// flight apart leave open at which speed the ball was reflected, so they show no rule.
TEST(ConservesEnergy, RecognisesABounceRuleOnlyByWhatItAdds) {
  World world;
  world.gravity_W = {0, -10, 0};
  world.dt = 0.01;
  world.steps = 80;
  world.bodies = {BodyOf("ball", Sphere{0.1}, 2, {0, 10, 0})};
  world.bodies[0].v_WB = {0, -5, 0};
  const auto bounced = [&](double gains) {
    return Sampled(world, [&](double t) {
      BodyState ball{{0, 10, 0}, Eigen::Quaterniond::Identity(), {0, 0, 0}, {0, 0, 0}};
      const double fall = std::min(t, 0.4);
      const double impact = 5 + 10 * 0.4;
      const double after =
          std::sqrt(impact * impact + gains * 2 * world.dt * 10 * impact);
      ball.p_WB.y() -= fall * (5 + 5 * fall);
      ball.v_WB.y() = -5 - 10 * fall;
      if (t > 0.4) {
        ball.v_WB.y() = after - 10 * (t - 0.4);
        ball.p_WB.y() += (t - 0.4) * (after - 5 * (t - 0.4));
      }
      return WorldState{{ball}, {}, {}};
    });
  };
  const auto recognised = [&](double gains) {
    return Of(Judge(world, bounced(gains), ClaimOf("conserves_energy")),
              MeasureKind::kEnergyDrift);
  };
  world.sample_every = 1;
  EXPECT_EQ(recognised(2).recognised, "");
  EXPECT_GT(recognised(2).value, recognised(2).tolerance.value);
  world.sample_every = 20;
  EXPECT_EQ(recognised(2).recognised, "");
  EXPECT_GT(recognised(2).value, recognised(2).tolerance.value);
}

TEST(ConservesEnergy, GrantsAnImpactTheAccelerationOfACornerForAStep) {
  World world = TumblingPlank();
  const Eigen::Vector3d J_W(0, 2, 0);
  const auto struck = [&] {
    return Sampled(world, [&](double t) {
      const Eigen::Vector3d v_WB =
          t < 2 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(J_W / 3);
      return WorldState{{{Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity(), v_WB,
                          world.bodies[0].w_WB}},
                        {},
                        {}};
    });
  };
  const auto drift = [&] {
    const Trajectory trajectory = struck();
    const Motion motion{world, DoubleEngine(), trajectory};
    return ImpactEnergyDrift(motion, AllowedMotion(motion), SubjectsOf(world, {})).back();
  };
  const Eigen::Vector3d I = Eigen::Vector3d(0.0425, 1.0025, 1.04);  // m (b² + c²)/3, …
  const Eigen::Vector3d w = world.bodies[0].w_WB;
  const double R = Eigen::Vector3d(1, 0.2, 0.05).norm();
  const double a =
      R * (w.squaredNorm() + w.cross(I.cwiseProduct(w)).cwiseQuotient(I).norm());
  EXPECT_NEAR(drift(), 0.5 * 2 * world.dt * a, 1e-9);
  world.bodies[0].w_WB.setZero();
  EXPECT_EQ(drift(), 0);
  world.bodies[0].w_WB = w;
  world.bodies[0].collides = false;
  EXPECT_EQ(drift(), 0);
  world.bodies[0].collides = true;
  world.bodies[0].placed.shape = Sphere{1};
  EXPECT_EQ(drift(), 0);
}

TEST(ConservesEnergy, DistinguishesNearlyEqualEnergiesInItsProof) {
  World world;
  world.particles = {{"arrow", {0, 0, 0}, {100, 0, 0}, 1}};
  world.gravity_W.setZero();
  world.dt = 1e-3;
  world.steps = 1;
  const Trajectory gained = Stepped(world, [](WorldState& state) {
    state.particles[0].v_W.x() *= 1 + 1e-11;
    state.particles[0].p_W.x() += 0.1;
  });
  for (const char* law : {"conserves_energy", "energy_never_rises"}) {
    const LawFinding found =
        Of(Judge(world, gained, ClaimOf(law)), MeasureKind::kEnergyDrift);
    EXPECT_GT(found.value, found.tolerance.value) << law;
    EXPECT_THAT(found.proof, testing::HasSubstr("has 5000.0000001 J after 0.001 s"));
    EXPECT_THAT(found.proof, testing::HasSubstr("5000 J"));
  }
}

TEST(ConservesEnergy, RefusesDampingAndAcceptsItsNumber) {
  EXPECT_FALSE(FaultsOf(SpringPair(0.1), ClaimOf("conserves_energy")).empty());
  World world;
  world.particles = {{"drop", {0, 3, 0}, {2, 0, 0}, 2}};
  EXPECT_TRUE(FaultsOf(world, ClaimOf("conserves_energy", {},
                                      {{"expected_energy", 4 + 2 * 9.82 * 3}}))
                  .empty());
}

TEST(EnergyNeverRises, ADampedSpringPasses) {
  const World world = SpringPair(0.7);
  EXPECT_TRUE(Passes(Judge(world, Swung(world), ClaimOf("energy_never_rises"))));
}

TEST(EnergyNeverRises, FindsDampingWithoutASign) {
  const World world = SpringPair(0.7);
  EXPECT_TRUE(Finds(Judge(world, Swung(world, 1, true), ClaimOf("energy_never_rises")),
                    MeasureKind::kEnergyDrift));
}

/** A box that falls to the ground beside a rod far away. */
World BoxAndRod(double restitution) {
  World world;
  world.bodies = {BodyOf("box", Box{{0.2, 0.2, 0.2}}, 1, {0, 0.5, 0}),
                  BodyOf("rod", Box{{0.5, 1e-3, 1e-3}}, 1, {9, 50, 0}), GroundOf()};
  for (RigidBody& body : world.bodies) body.restitution = restitution;
  world.dt = 1e-3;
  world.steps = 300;
  return world;
}

/** Both fall; the box bounces at the first touch with `gain` times its energy, and
 `boost` [J] come to the rod half way. */
Trajectory Fallen(const World& world, double gain, double boost) {
  int step = 0;
  return Stepped(world, [&, step](WorldState& state) mutable {
    for (std::size_t i = 0; i < 2; ++i) {
      BodyState& is = state.bodies[i];
      is.v_WB += world.dt * world.gravity_W;
      if (is.p_WB.y() <= 0.2 && is.v_WB.y() < 0) is.v_WB.y() *= -std::sqrt(gain);
      is.p_WB += world.dt * is.v_WB;
    }
    if (++step == world.steps / 2) {
      state.bodies[1].v_WB.z() = std::sqrt(2 * boost);
    }
  });
}

TEST(EnergyNeverRises, GrantsAnEccentricImpactWhatNewtonsRuleMayGain) {
  // σ² of a cube is 4.5: e² (1 + σ²) − 1 is 0.375 at e = ½, and nothing at e = 0.42.
  const auto judged = [](double restitution, double gain) {
    const World world = BoxAndRod(restitution);
    return Judge(world, Fallen(world, gain, 0), ClaimOf("energy_never_rises"));
  };
  EXPECT_TRUE(Passes(judged(0.42, 1)));
  EXPECT_TRUE(Finds(judged(0.42, 1.2), MeasureKind::kEnergyDrift));
  EXPECT_TRUE(Passes(judged(0.5, 1.2)));
  EXPECT_TRUE(Finds(judged(0.5, 2), MeasureKind::kEnergyDrift));
}

// The slide is no approach: all that a cube of 1 kg at rest on the ground may gain in a
// step is of the order of m (g h)².
TEST(EnergyNeverRises, FindsFrictionThatDrivesASlidingBox) {
  World world = BoxAndRod(0.5);
  world.bodies[0].placed.X_WB.p_WB.y() = 0.2;
  world.bodies[0].v_WB = {10, 0, 0};
  const auto slide = [&](double acceleration) {
    return Stepped(world, [&](WorldState& state) {
      BodyState& box = state.bodies[0];
      box.v_WB.x() += world.dt * acceleration;
      box.p_WB.x() += world.dt * box.v_WB.x();
      BodyState& rod = state.bodies[1];
      rod.v_WB += world.dt * world.gravity_W;
      rod.p_WB += world.dt * rod.v_WB;
    });
  };
  const Claim claim = ClaimOf("energy_never_rises");
  EXPECT_TRUE(Passes(Judge(world, slide(-1), claim)));
  EXPECT_TRUE(Finds(Judge(world, slide(1), claim), MeasureKind::kEnergyDrift));
}

TEST(EnergyNeverRises, GrantsNothingToWhatMeetsNothing) {
  const World world = BoxAndRod(0.5);
  EXPECT_TRUE(
      Passes(Judge(world, Fallen(world, 0.25, 0), ClaimOf("energy_never_rises"))));
  for (const std::vector<std::string>& about :
       {std::vector<std::string>{}, std::vector<std::string>{"rod"}}) {
    EXPECT_TRUE(
        Finds(Judge(world, Fallen(world, 0.25, 6), ClaimOf("energy_never_rises", about)),
              MeasureKind::kEnergyDrift));
  }
}

TEST(ImpactGain, KnowsTheEccentricityOfShapes) {
  const auto of = [](const Shape& shape) {
    return Eccentricity(BodyOf("it", shape, 2, {0, 0, 0}));
  };
  EXPECT_EQ(of(Sphere{0.3}), 0);
  EXPECT_NEAR(of(Box{{1, 1, 1}}), 4.5, 1e-12);
  EXPECT_NEAR(of(Box{{1, 1e-3, 1e-3}}), 6, 1e-4);
  EXPECT_NEAR(of(Box{{1, 1, 1e-6}}), 6, 1e-9);
}

TEST(ImpactGain, BoundsEveryPlanarImpact) {
  // A rod of length 2 with moment m/3: a contact at any place r and any normal.
  double largest = 0;
  for (const double e : {0.5, 0.7, 0.85, 1.0}) {
    const double most = MostImpactGain(e, 3);
    for (int i = 0; i < 4000; ++i) {
      const double angle = 0.37 * i;
      const double p = std::sqrt(3) * std::cos(angle);
      const double q = std::sqrt(3) * std::sin(angle);
      Eigen::Matrix2d K;
      K << 1 + p * p, -p * q, -p * q, 1 + q * q;
      const InPlane u(-1, 4 * std::sin(1.7 * i));
      const double friction = std::fmod(0.11 * i, 2);
      const InPlane J = PlanarImpulse(ImpactRule::kNewton, K, u, e, friction);
      const double gained = J.dot(u + K * J / 2);
      const double approach = u.dot(K.inverse() * u) / 2;
      EXPECT_LE(gained, most * approach + 1e-12) << e << " " << i;
      largest = std::max(largest, gained / approach);
    }
  }
  EXPECT_GT(largest, 0.1);
}

TEST(Energy, AClothHasTheEnergyOfItsSprings) {
  World world;
  Cloth cloth;
  cloth.name = "cloth";
  cloth.structural = {10, 0};
  cloth.shear = {20, 0};
  cloth.bend = {30, 0};
  world.cloths = {cloth};
  world.gravity_W.setZero();
  EXPECT_EQ(SpringsOf(cloth).size(), 12U + 8U + 6U);
  WorldState state = StateAtStart(world);
  const Subjects all = SubjectsOf(world, ClaimOf("conserves_energy"));
  EXPECT_NEAR(EnergyOf(world, state, all).total(), 0, 1e-12);
  // Twice as large: every spring is stretched by its rest length.
  for (PointState& node : state.nodes) node.p_W *= 2;
  EXPECT_NEAR(EnergyOf(world, state, all).total(), 12 * 5 + 8 * 10 * 2.0 + 6 * 15 * 4.0,
              1e-9);
}

/** Returns the tolerance of the energy of a world that starts at rest and stays so. */
double GrantedAtRest(const World& world) {
  const Trajectory rests = Sampled(world, [&](double) { return StateAtStart(world); });
  return Of(Judge(world, rests, ClaimOf("energy_never_rises")), MeasureKind::kEnergyDrift)
      .tolerance.value;
}

/** Balls of 1 kg and radius 0.5 m above the ground, with their centres at `places`. */
World Sunk(const std::vector<Eigen::Vector3d>& places) {
  World world;
  world.bodies = {GroundOf()};
  for (std::size_t i = 0; i < places.size(); ++i)
    world.bodies.push_back(BodyOf(fmt::format("ball {}", i), Sphere{0.5}, 1, places[i]));
  world.dt = 1e-6;
  world.steps = 5;
  return world;
}

TEST(Energy, PartingOverlapsLiftsEachClusterByItsOwnDepths) {
  constexpr double kWork = 0.01 * 9.82;  // Of one ball. [J]
  for (const double apart : {1.0, 1.1}) {
    std::vector<Eigen::Vector3d> row;
    row.reserve(50);
    for (int i = 0; i < 50; ++i) row.emplace_back(i * apart, 0.49, 0);
    EXPECT_NEAR(GrantedAtRest(Sunk(row)), 50 * kWork, 1e-3) << apart;
  }
}

TEST(Energy, PartingOverlapsLiftsWhatRestsOnTheClusterOrHangsOnIt) {
  constexpr double kWork = 0.01 * 9.82;
  const World two = Sunk({{0, 0.49, 0}, {0, 1.49, 0}});
  EXPECT_NEAR(GrantedAtRest(two), 2 * kWork, 1e-4);
  const World near = Sunk({{0, 0.49, 0}, {0, 1.495, 0}});
  EXPECT_NEAR(GrantedAtRest(near), 2 * kWork, 1e-4);
  const World above = Sunk({{0, 0.49, 0}, {0, 1.6, 0}});
  EXPECT_NEAR(GrantedAtRest(above), kWork, 1e-4);
  World held = Sunk({{0, 0.49, 0}, {3, 4, 0}});
  held.joints = {{{AnchorKind::kBody, 1, {0, 0, 0}},
                  {AnchorKind::kBody, 2, {0, 0, 0}},
                  Eigen::Vector3d(3, 3.51, 0).norm()}};
  EXPECT_NEAR(GrantedAtRest(held), 2 * kWork, 1e-4);
}

TEST(TurnsOnce, conserves_momentum) {
  const World world = SpringPair();
  EXPECT_TRUE(TurnsOnce(world, Swung(world), ClaimOf("conserves_momentum")));
}

TEST(TurnsOnce, conserves_energy) {
  const World world = SpringPair();
  EXPECT_TRUE(TurnsOnce(world, Swung(world), ClaimOf("conserves_energy")));
}

TEST(TurnsOnce, energy_never_rises) {
  const World world = SpringPair(0.7);
  EXPECT_TRUE(TurnsOnce(world, Swung(world), ClaimOf("energy_never_rises"), {0, 1, 0}));
}

TEST(ConservesMomentum, AndEnergyHaveAFloorAtRest) {
  // Two particles on a rod rest; an engine takes velocities from positions that are
  // rounded, and they are gone after some steps.
  World world;
  world.particles = {{"a", {0, 0, 0}, {0, 0, 0}, 1.5},
                     {"b", {0.3, 0.4, 0}, {0, 0, 0}, 0.5}};
  world.joints = {{{AnchorKind::kParticle, 0, {0, 0, 0}},
                   {AnchorKind::kParticle, 1, {0, 0, 0}},
                   0.5}};
  world.gravity_W.setZero();
  world.dt = 1e-3;
  world.steps = 100;
  const auto trembling = [&](double noise) {
    return Sampled(world, [&](double t) {
      WorldState state = StateAtStart(world);
      state.particles[1].v_W = Eigen::Vector3d(noise * std::exp(-100 * t), 0, 0);
      if (t == 0) state.particles[1].v_W.setZero();
      return state;
    });
  };
  const double u_x_over_h = 0x1p-53 * 0.5 / world.dt;
  for (const char* law : {"conserves_momentum", "conserves_energy"}) {
    EXPECT_TRUE(Passes(Judge(world, trembling(0.5 * u_x_over_h), ClaimOf(law)))) << law;
    EXPECT_TRUE(Passes(Judge(world, trembling(1e-22), ClaimOf(law)))) << law;
    const std::vector<LawFinding> found =
        Judge(world, trembling(4 * u_x_over_h), ClaimOf(law));
    EXPECT_GT(found[0].value, found[0].tolerance.value) << law;
  }
}

}  // namespace
}  // namespace touchstone
