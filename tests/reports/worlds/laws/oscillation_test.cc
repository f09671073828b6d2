#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "reports/worlds/laws/laws.h"
#include "reports/worlds/truth/oscillator.h"
#include "reports/worlds/truth/pendulum.h"
#include "reports/worlds/truth/rods.h"
#include "tests/reports/worlds/motions.h"
#include "tests/reports/worlds/runge_kutta.h"

namespace touchstone {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Oscillator, AgreesWithAnIntegrationOnBothSidesOfCriticalDamping) {
  for (const double c : {0.0, 0.3, 3.999999, 4.0, 4.1, 9.0}) {
    const Oscillator oscillator{2, c};
    const auto field = [&](const Eigen::Vector2d& y) {
      return Eigen::Vector2d(y.y(), -4 * y.x() - c * y.y());
    };
    const Eigen::Vector2d y = Integrated(field, Eigen::Vector2d(0.7, -1.1), 3.0, 2000);
    const Swing at = oscillator.After({0.7, -1.1}, 3.0);
    EXPECT_NEAR(at.x, y.x(), 1e-10) << c;
    EXPECT_NEAR(at.v, y.y(), 1e-10) << c;
  }
}

TEST(Oscillator, SteppedVelocityFirstHasItsDiscreteClosedForm) {
  const Oscillator oscillator{10, 0};
  const double h = 0.01;
  const double theta = std::acos(1 - 50 * h * h);
  Swing swing{1, 0};
  const Swing first = Stepped(SwingScheme::kVelocityFirst, oscillator, h, swing);
  const double B = (first.x - std::cos(theta)) / std::sin(theta);
  for (int n = 0; n < 500; ++n) {
    EXPECT_NEAR(swing.x, std::cos(n * theta) + B * std::sin(n * theta), 1e-11);
    swing = Stepped(SwingScheme::kVelocityFirst, oscillator, h, swing);
  }
}

/** A 2 kg ball on a spring below a fixed point, along a gravity that is along no axis. */
World Sprung(double damping, double dt = 1e-3) {
  World world;
  const Eigen::Vector3d down = Eigen::Vector3d(1, -3, 0.5).normalized();
  RigidBody ball =
      BodyOf("ball", Sphere{0.1}, 2, Eigen::Vector3d(0.3, 2, 0) + 1.4 * down);
  ball.v_WB = 0.6 * down;
  world.bodies = {ball};
  world.gravity_W = 9.81 * down;
  world.springs.push_back({{AnchorKind::kWorld, -1, {0.3, 2, 0}},
                           {AnchorKind::kBody, 0, {0, 0, 0}},
                           200,
                           damping,
                           1.2});
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(3 / dt));
  return world;
}

Trajectory Sprung(const World& world, SwingScheme scheme, double omega, double c) {
  const Eigen::Vector3d down = world.gravity_W.normalized();
  Swing swing{1.4 - 1.2 - 9.81 / 100, 0.6};
  return Stepped(world,
                 [&world, scheme, omega, c, down, swing](WorldState& state) mutable {
                   swing = Stepped(scheme, {omega, c}, world.dt, swing);
                   state.bodies[0].p_WB =
                       Eigen::Vector3d(0.3, 2, 0) + (1.2 + 9.81 / 100 + swing.x) * down;
                   state.bodies[0].v_WB = swing.v * down;
                 });
}

TEST(SpringOscillation, FirstOrderSchemesPass) {
  for (const double dt : {1.0 / 240, 1e-3}) {
    for (const double b : {0.0, 3.0}) {
      const World world = Sprung(b, dt);
      for (const SwingScheme scheme : kSymplecticSwings) {
        EXPECT_TRUE(Passes(Judge(world, Sprung(world, scheme, 10, b / 2),
                                 ClaimOf("spring_oscillation"))))
            << dt << " " << b;
      }
    }
  }
}

TEST(SpringOscillation, RecognisesImplicitAndExplicitEuler) {
  const World world = Sprung(0);
  for (const auto& [scheme, name] :
       {std::pair(SwingScheme::kImplicit, "implicit Euler"),
        std::pair(SwingScheme::kExplicit, "explicit Euler")}) {
    EXPECT_EQ(
        Of(Judge(world, Sprung(world, scheme, 10, 0), ClaimOf("spring_oscillation")),
           MeasureKind::kPositionError)
            .recognised,
        name);
  }
}

TEST(SpringOscillation, FindsAnotherStiffnessAndDamping) {
  const World world = Sprung(3);
  EXPECT_TRUE(Finds(Judge(world, Sprung(world, SwingScheme::kVelocityFirst, 10.2, 1.5),
                          ClaimOf("spring_oscillation")),
                    MeasureKind::kPositionError));
  EXPECT_TRUE(Finds(Judge(world, Sprung(world, SwingScheme::kVelocityFirst, 10, 1.6),
                          ClaimOf("spring_oscillation")),
                    MeasureKind::kPositionError));
}

TEST(SpringOscillation, KnowsItsNumbersAndRefusesSidewaysMotionAndStiffSprings) {
  World world = Sprung(0);
  EXPECT_TRUE(
      FaultsOf(world, ClaimOf("spring_oscillation", {},
                              {{"expected_period", kPi / 5}, {"expected_sag", 0.0981}}))
          .empty());
  world.bodies[0].v_WB += Eigen::Vector3d(0, 0, 1);
  EXPECT_EQ(FaultsOf(world, ClaimOf("spring_oscillation")).size(), 1U);
  world = Sprung(0);
  world.springs[0].stiffness = 9e6;
  EXPECT_EQ(FaultsOf(world, ClaimOf("spring_oscillation")).size(), 1U);
}

TEST(Pendulum, HasThePublishedPeriodAndPositions) {
  // IFToMM A01: 1 m, g = 9.81, from rest at 90°.
  const Pendulum pendulum(std::sqrt(9.81), {kPi / 2, 0});
  EXPECT_NEAR(pendulum.period(), 2.367841947576, 1e-11);
  struct Row {
    double t, x, y;
  };
  for (const Row& row :
       {Row{1, -0.986291751132, -0.165010853126}, Row{2, 0.793566195343, -0.608483930444},
        Row{5, 0.942305435044, -0.334754338414},
        Row{10, 0.275087462576, -0.961419205099}}) {
    const double theta = pendulum.At(row.t).theta;
    EXPECT_NEAR(std::sin(theta), row.x, 1e-11) << row.t;
    EXPECT_NEAR(-std::cos(theta), row.y, 1e-11) << row.t;
  }
}

TEST(Pendulum, AgreesWithAnIntegrationSwingingAndTurningOver) {
  const double omega = 3.1;
  for (const Eigen::Vector2d& start :
       {Eigen::Vector2d(0.4, 0), Eigen::Vector2d(-2.9, 0.1), Eigen::Vector2d(1, -2),
        Eigen::Vector2d(0, 6.1), Eigen::Vector2d(0.5, 9), Eigen::Vector2d(-2, -8)}) {
    const Pendulum pendulum(omega, {start.x(), start.y()});
    const auto field = [&](const Eigen::Vector2d& y) {
      return Eigen::Vector2d(y.y(), -omega * omega * std::sin(y.x()));
    };
    for (const double t : {0.3, 1.7}) {
      const Eigen::Vector2d y = Integrated(field, start, t, 4000);
      const PendulumAngle at = pendulum.At(t);
      EXPECT_NEAR(std::remainder(at.theta - y.x(), 2 * kPi), 0, 1e-9)
          << start.transpose();
      EXPECT_NEAR(at.rate, y.y(), 1e-9) << start.transpose();
    }
  }
}

RodSystem TwoRods() {
  return {{1, 1}, {{0, -1, {0, 0, 0}, 1}, {1, 0, {0, 0, 0}, 1}}, {0, -9.81, 0}};
}

TEST(RodSystem, HasThePublishedPositionsOfTheDoublePendulum) {
  // Both rods are level at the start, at rest.
  const std::vector<PointState> start = {{{1, 0, 0}, {0, 0, 0}}, {{2, 0, 0}, {0, 0, 0}}};
  struct Row {
    double t, x1, y1, x2, y2;
  };
  for (const Row& row :
       {Row{0.5, 0.5400294090, -0.8416461474, 1.4734656701, -1.2003894352},
        Row{1, -0.5851683920, -0.8109118035, -1.4448188499, -1.3217944614},
        Row{2, -0.4644128687, -0.8856188161, -1.4341248175, -1.1298701956}}) {
    const std::vector<PointState> at = TwoRods().After(start, row.t);
    EXPECT_LE((at[0].p_W - Eigen::Vector3d(row.x1, row.y1, 0)).norm(), 2e-10) << row.t;
    EXPECT_LE((at[1].p_W - Eigen::Vector3d(row.x2, row.y2, 0)).norm(), 2e-10) << row.t;
  }
}

TEST(RodSystem, OneRodIsThePendulum) {
  const RodSystem system{{3}, {{0, -1, {0.1, 0.2, 0}, 0.7}}, {0, -9.81, 0}};
  const Pendulum pendulum(std::sqrt(9.81 / 0.7), {1.9, 0});
  const std::vector<PointState> start = {
      {{0.1 + 0.7 * std::sin(1.9), 0.2 - 0.7 * std::cos(1.9), 0}, {0, 0, 0}}};
  const double theta = pendulum.At(3.3).theta;
  EXPECT_LE((system.After(start, 3.3)[0].p_W -
             Eigen::Vector3d(0.1 + 0.7 * std::sin(theta), 0.2 - 0.7 * std::cos(theta), 0))
                .norm(),
            1e-11);
}

// A heavy mass swings below a light one. At its lowest point it pulls the rods straight.
// The light mass then snaps to the other side, many times faster than any mass at the
// start.
TEST(RodSystem, KeepsTheEnergyOfALightMassThatSnapsThrough) {
  const RodSystem system{
      {2, 7000}, {{0, -1, {0, 0, 0}, 1}, {1, 0, {0, 0, 0}, 0.4}}, {0, -9.82, 0}};
  const std::vector<PointState> start = {{{0.8, -0.6, 0}, {0, 0, 0}},
                                         {{0.4, -0.6, 0}, {0, 0, 0}}};
  const auto energy = [&](const std::vector<PointState>& state) {
    double sum = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
      sum += system.mass[i] *
             (0.5 * state[i].v_W.squaredNorm() - system.g_W.dot(state[i].p_W));
    }
    return sum;
  };
  double fastest = 0;
  std::vector<PointState> state = start;
  for (int k = 0; k < 100; ++k) {
    state = system.After(state, 0.01);
    EXPECT_NEAR(energy(state), energy(start), 1e-8 * std::abs(energy(start))) << k;
    EXPECT_NEAR(state[0].p_W.norm(), 1, 1e-8) << k;
    fastest = std::max(fastest, state[0].v_W.norm());
  }
  // A fall of 1.4 m gives 5.3 m/s.
  EXPECT_GT(fastest, 7) << "it snaps";
}

TEST(RodSystem, SteppedConvergesToItsMotionAtFirstOrder) {
  const std::vector<PointState> start = {{{1, 0, 0}, {0, 0, 0}}, {{2, 0, 0}, {0, 0, 0}}};
  const std::vector<PointState> truth = TwoRods().After(start, 0.8);
  for (const RodScheme scheme : kRodSchemes) {
    const auto error = [&](int steps) {
      std::vector<PointState> state = start;
      for (int i = 0; i < steps; ++i) StepRods(scheme, TwoRods(), 0.8 / steps, state);
      return (state[1].p_W - truth[1].p_W).norm();
    };
    EXPECT_NEAR(error(1000) / error(2000), 2, 0.1);
  }
}

/** A single or a double pendulum, in a plane that contains only one world axis. */
World Hung(int points, double dt = 1e-3) {
  World world;
  world.gravity_W = {0, -9.81, 0};
  const Eigen::Vector3d along = Eigen::Vector3d(2, 0, 1).normalized();
  for (int i = 0; i < points; ++i) {
    world.particles.push_back(
        {"mass" + std::to_string(i), (i + 1) * along, {0, 0, 0}, 1, 0, 0});
    world.joints.push_back({i == 0 ? Anchor{AnchorKind::kWorld, -1, {0, 0, 0}}
                                   : Anchor{AnchorKind::kParticle, i - 1, {0, 0, 0}},
                            {AnchorKind::kParticle, i, {0, 0, 0}},
                            1});
  }
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(2 / dt));
  world.sample_every = 4;
  return world;
}

RodSystem SystemOf(const World& world, double g = 9.81) {
  RodSystem system{{}, {}, {0, -g, 0}};
  for (std::size_t i = 0; i < world.particles.size(); ++i) {
    system.mass.push_back(1);
    const int point = static_cast<int>(i);
    system.rods.push_back({point, point - 1, {0, 0, 0}, 1});
  }
  return system;
}

Trajectory Swung(const World& world, RodScheme scheme, double g = 9.81) {
  const RodSystem system = SystemOf(world, g);
  return Stepped(world, [&world, scheme, system](WorldState& state) {
    StepRods(scheme, system, world.dt, state.particles);
  });
}

std::vector<PointState> StartOf(const World& world) {
  std::vector<PointState> start;
  start.reserve(world.particles.size());
  for (const Particle& particle : world.particles)
    start.push_back({particle.p_W, particle.v_W});
  return start;
}

Trajectory Exactly(const World& world) {
  const RodSystem system = SystemOf(world);
  return Sampled(world, [&world, system](double t) {
    WorldState state;
    state.particles = system.After(StartOf(world), t);
    return state;
  });
}

TEST(Pendulum, TheLawPassesTheTruthAndFirstOrderSchemes) {
  const World world = Hung(1);
  const Claim claim = ClaimOf("pendulum", {}, {{"expected_period", 2.367841947576}});
  EXPECT_TRUE(Passes(Judge(world, Exactly(world), claim)));
  for (const RodScheme scheme : kRodSchemes)
    EXPECT_TRUE(Passes(Judge(world, Swung(world, scheme), claim)));
}

TEST(Pendulum, TheLawFindsAnotherGravity) {
  const World world = Hung(1);
  EXPECT_TRUE(
      Finds(Judge(world, Swung(world, RodScheme::kBaumgarte, 9.0), ClaimOf("pendulum")),
            MeasureKind::kPositionError));
}

TEST(Pendulum, TheLawRefusesOtherMotions) {
  World world = Hung(1);
  world.particles[0].v_W = {1, 0, 0};
  EXPECT_EQ(FaultsOf(world, ClaimOf("pendulum")).size(), 1U);
  world = Hung(1);
  world.joints[0].length = 1.1;
  EXPECT_EQ(FaultsOf(world, ClaimOf("pendulum")).size(), 1U);
}

TEST(PendulumOfTwo, TheTruthAndFirstOrderSchemesPass) {
  const World world = Hung(2);
  const Claim claim = ClaimOf("pendulum", {"mass0", "mass1"});
  EXPECT_TRUE(Passes(Judge(world, Exactly(world), claim)));
  for (const RodScheme scheme : kRodSchemes)
    EXPECT_TRUE(Passes(Judge(world, Swung(world, scheme), claim)));
}

/** Advances a chain of points of 1 kg on rods by a step that keeps the lengths by mean
 velocities: x₁ = x₀ + h (v₀ + v₁)/2, with impulses along the mean directions of the rods.
 Gauss-Seidel over the rods. */
void StepByMeanVelocities(const RodSystem& system, double h,
                          std::vector<PointState>& state) {
  const std::vector<PointState> before = state;
  for (PointState& point : state) point.v_W += h * system.g_W;
  for (int round = 0; round < 100; ++round) {
    for (std::size_t i = 0; i < state.size(); ++i)
      state[i].p_W = before[i].p_W + h / 2 * (before[i].v_W + state[i].v_W);
    for (std::size_t i = 0; i < state.size(); ++i) {
      const auto along = [&](const std::vector<PointState>& points) -> Eigen::Vector3d {
        return i == 0 ? points[i].p_W : points[i].p_W - points[i - 1].p_W;
      };
      const Eigen::Vector3d mean = (along(before) + along(state)) / 2;
      const double missing = (1 - along(state).squaredNorm()) / 2;
      const Eigen::Vector3d J =
          missing / (h / 2 * (i == 0 ? 1 : 2) * mean.squaredNorm()) * mean;
      state[i].v_W += J;
      state[i].p_W += h / 2 * J;
      if (i == 0) continue;
      state[i - 1].v_W -= J;
      state[i - 1].p_W -= h / 2 * J;
    }
  }
}

// Rods that are level and thrown up fall nearly freely: first-order engines are right for
// a few steps.
World ThrownUp() {
  World world = Hung(2, 1.0 / 60);
  for (Particle& particle : world.particles) particle.v_W = {0, 0.18, 0};
  world.sample_every = 1;
  return world;
}

TEST(PendulumOfTwo, AnEngineThatKeepsLengthsByMeanVelocitiesPasses) {
  const World world = ThrownUp();
  const RodSystem system = SystemOf(world);
  const Trajectory motion = Stepped(world, [&](WorldState& state) {
    StepByMeanVelocities(system, world.dt, state.particles);
  });
  const Claim claim = ClaimOf("pendulum", {"mass0", "mass1"}, {{"until", 0.5}});
  EXPECT_TRUE(Passes(Judge(world, motion, claim)));
}

// Such an engine is off by 2e-4 m/s there.
TEST(PendulumOfTwo, FindsAVelocityThatIsOffByAMillimetreASecondNearFreeFall) {
  const World world = ThrownUp();
  const Claim claim = ClaimOf("pendulum", {"mass0", "mass1"}, {{"until", 0.05}});
  Trajectory motion = Exactly(world);
  EXPECT_TRUE(Passes(Judge(world, motion, claim)));
  for (std::size_t s = 1; s < motion.samples.size(); ++s)
    motion.samples[s].particles[0].v_W.x() += 1e-3;
  EXPECT_TRUE(Finds(Judge(world, motion, claim), MeasureKind::kVelocityError));
}

TEST(PendulumOfTwo, FindsAnotherMassAndTakesPointsInOrder) {
  const World world = Hung(2);
  const Claim claim = ClaimOf("pendulum", {"mass0", "mass1"}, {{"until", 1.5}});
  RodSystem heavy = SystemOf(world);
  heavy.mass[1] = 1.2;
  const Trajectory moved = Stepped(world, [&](WorldState& state) {
    StepRods(RodScheme::kBaumgarte, heavy, world.dt, state.particles);
  });
  EXPECT_TRUE(Finds(Judge(world, moved, claim), MeasureKind::kPositionError));
  EXPECT_EQ(FaultsOf(world, ClaimOf("pendulum", {"mass1", "mass0"})).size(), 1U);
}

TEST(PendulumOfTwo, RefusesAMotionAlongARodAndAnotherHold) {
  World world = Hung(2);
  const Eigen::Vector3d along = world.particles[0].p_W;
  world.particles[1].v_W = along;
  EXPECT_EQ(FaultsOf(world, ClaimOf("pendulum")).size(), 1U);
  // Both move along, so the first leaves its fixed point.
  world.particles[0].v_W = along;
  EXPECT_EQ(FaultsOf(world, ClaimOf("pendulum")).size(), 1U);
  for (const int held : {0, 1}) {
    world = Hung(2);
    world.joints.push_back({{AnchorKind::kWorld, -1, {0, 3, 0}},
                            {AnchorKind::kParticle, held, {0, 0, 0}},
                            1});
    EXPECT_EQ(FaultsOf(world, ClaimOf("pendulum")).size(), 1U);
  }
}

TEST(Pendulum, IsJudgedAtASampleAfterTheStart) {
  const World world = Hung(1);
  for (const double until : {-1.0, 0.0, 0.003}) {
    EXPECT_EQ(FaultsOf(world, ClaimOf("pendulum", {}, {{"until", until}})).front().where,
              "numbers.until");
  }
  EXPECT_TRUE(FaultsOf(world, ClaimOf("pendulum", {}, {{"until", 0.004}})).empty());
}

TEST(PendulumOfTwo, HasNoPeriod) {
  EXPECT_EQ(FaultsOf(Hung(2), ClaimOf("pendulum", {}, {{"expected_period", 2.4}})).size(),
            1U);
}

TEST(PendulumOfThree, PassesTheTruthAndFindsAnotherMass) {
  World world = Hung(3);
  world.sample_every = 50;
  const Claim claim = ClaimOf("pendulum", {}, {{"until", 1}});
  EXPECT_TRUE(Passes(Judge(world, Exactly(world), claim)));
  RodSystem heavy = SystemOf(world);
  heavy.mass[2] = 1.2;
  const Trajectory moved = Stepped(world, [&](WorldState& state) {
    StepRods(RodScheme::kBaumgarte, heavy, world.dt, state.particles);
  });
  EXPECT_TRUE(Finds(Judge(world, moved, claim), MeasureKind::kPositionError));
}

TEST(Pendulum, ShowsPlacesUntilItIsJudged) {
  for (const int points : {1, 2}) {
    const World world = Hung(points);
    const Claim claim = ClaimOf("pendulum", {}, {{"until", 0.5}});
    const std::vector<Eigen::Vector3d> places =
        FindLaw("pendulum")->places(world, claim, {0, 0.25, 0.5, 0.75});
    ASSERT_EQ(places.size(), 3U);
    const PointState exact = SystemOf(world).After(StartOf(world), 0.5).front();
    EXPECT_LE((places[2] - exact.p_W).norm(), 1e-9) << points;
  }
}

TEST(JointLength, FirstOrderSchemesPass) {
  for (const int points : {1, 2}) {
    const World world = Hung(points);
    for (const RodScheme scheme : kRodSchemes) {
      EXPECT_TRUE(Passes(Judge(world, Swung(world, scheme), ClaimOf("joint_length"))));
    }
  }
}

// The anchor turns about the centre of the ball: its way bends by ω² r besides v²/L.
TEST(JointLength, AShortRodAtTheSurfaceOfABallThatSwingsMayStretchWithTheStep) {
  for (const double length : {0.1, 0.25, 1.0}) {
    World world;
    RigidBody ball = BodyOf("ball", Sphere{0.25}, 2, {0, 0, 0});
    const Eigen::Vector3d r_B(0, 0.25, 0);
    const Eigen::Quaterniond tilt =
        Turned(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0, 0, 1));
    ball.placed.X_WB =
        Pose::FromQuaternion(tilt * Eigen::Vector3d(0, -0.25 - length, 0), tilt);
    world.bodies = {ball};
    world.joints = {{{}, {AnchorKind::kBody, 0, r_B}, length}};
    world.steps = 1200;
    const double I = InertiaOf(ball).x();
    const auto swung = [&](double stretched_by) {
      return Stepped(world, [&, stretched_by](WorldState& state) {
        // Semi-implicit Euler; the impulse of the rod acts on the velocities alone.
        BodyState& is = state.bodies[0];
        is.v_WB += world.dt * world.gravity_W;
        const Eigen::Vector3d r_W = is.q_WB * r_B;
        const Eigen::Vector3d n_W = (is.p_WB + r_W).normalized();
        const Eigen::Vector3d lever = r_W.cross(n_W);
        const double u = n_W.dot(is.v_WB + is.w_WB.cross(r_W)) - stretched_by;
        const double J = -u / (1 / ball.mass + lever.squaredNorm() / I);
        is.v_WB += J / ball.mass * n_W;
        is.w_WB += J / I * lever;
        is.p_WB += world.dt * is.v_WB;
        is.q_WB = Turned(is.q_WB, world.dt * is.w_WB);
      });
    };
    EXPECT_TRUE(Passes(Judge(world, swung(0), ClaimOf("joint_length")))) << length;
    EXPECT_TRUE(Finds(Judge(world, swung(0.02), ClaimOf("joint_length")),
                      MeasureKind::kJointError))
        << length;
  }
}

TEST(JointLength, FindsAnElasticRod) {
  // A stiff spring in place of the rod: gravity stretches it by m g/k.
  const World world = Hung(1);
  const Trajectory moved = Stepped(world, [&world](WorldState& state) {
    PointState& mass = state.particles[0];
    const double length = mass.p_W.norm();
    mass.v_W += world.dt * (world.gravity_W - 2000 * (length - 1) / length * mass.p_W);
    mass.p_W += world.dt * mass.v_W;
  });
  EXPECT_TRUE(
      Finds(Judge(world, moved, ClaimOf("joint_length")), MeasureKind::kJointError));
  World free = world;
  free.joints.clear();
  EXPECT_EQ(FaultsOf(free, ClaimOf("joint_length")).size(), 1U);
}

TEST(TurnsOnce, spring_oscillation) {
  const World world = Sprung(0);
  EXPECT_TRUE(TurnsOnce(world, Sprung(world, kSymplecticSwings[0], 10, 0),
                        ClaimOf("spring_oscillation")));
}

TEST(TurnsOnce, pendulum) {
  const World world = Hung(1);
  EXPECT_TRUE(TurnsOnce(world, Exactly(world), ClaimOf("pendulum")));
}

TEST(TurnsOnce, pendulum_of_two) {
  const World world = Hung(2);
  EXPECT_TRUE(TurnsOnce(world, Exactly(world), ClaimOf("pendulum", {"mass0", "mass1"})));
}

TEST(TurnsOnce, joint_length) {
  // Down, away from the hook that the rod hangs from: it only becomes longer.
  const World world = Hung(1);
  EXPECT_TRUE(TurnsOnce(world, Exactly(world), ClaimOf("joint_length"),
                        -Eigen::Vector3d::UnitY()));
}

}  // namespace
}  // namespace touchstone
