#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "reports/worlds/truth/catenary.h"
#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/net.h"
#include "reports/worlds/truth/net_motion.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

HangingChain EqualChain(int links, double length, double span, double mass, double k) {
  HangingChain chain;
  chain.from_W = {0, 0, 0};
  chain.to_W = {span, 0, 0};
  chain.weight_W.assign(static_cast<std::size_t>(links - 1), {0, -9.81 * mass, 0});
  chain.rest_length.assign(static_cast<std::size_t>(links), length);
  chain.stiffness.assign(static_cast<std::size_t>(links), k);
  return chain;
}

double SagOf(const Catenary& catenary) {
  double lowest = 0;
  for (const Eigen::Vector3d& p : catenary.points_W) lowest = std::min(lowest, p.y());
  return -lowest;
}

TEST(Catenary, HasThePublishedTensionsAndSags) {
  struct Row {
    int n;
    double span, mass, k, H, sag;
  };
  for (const Row& row : {Row{10, 0.6, 0.05, kInfinite, 0.799083227, 0.365545036},
                         Row{20, 1.5, 0.1, kInfinite, 5.441783726, 0.589502100},
                         Row{20, 1.5, 0.1, 1000, 4.597570137, 0.685588078}}) {
    const Catenary catenary =
        CatenaryOf(EqualChain(row.n, 0.1, row.span, row.mass, row.k));
    EXPECT_NEAR(catenary.tension_W.front().x(), row.H, 1e-8) << row.n;
    EXPECT_NEAR(SagOf(catenary), row.sag, 1e-8) << row.n;
  }
  HangingChain string = EqualChain(11, 0.1, 0, 0.05, 500);
  string.free_end = true;
  string.rest_length.pop_back();
  string.stiffness.pop_back();
  EXPECT_NEAR(SagOf(CatenaryOf(string)), 1.053955, 1e-7);
}

TEST(Catenary, OfRodsIsTheDiscreteCatenary) {
  const int n = 10;
  const Catenary catenary = CatenaryOf(EqualChain(n, 0.1, 0.6, 0.05, kInfinite));
  const double H = catenary.tension_W.front().x();
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d& T = catenary.tension_W[static_cast<std::size_t>(i)];
    EXPECT_NEAR(T.y() / T.x(), (i - (n - 1) / 2.0) * 0.05 * 9.81 / H, 1e-12);
  }
}

TEST(Net, HangsAsTheCatenaryOfItsSprings) {
  const HangingChain chain = EqualChain(12, 0.1, 0.8, 0.1, 300);
  const Catenary catenary = CatenaryOf(chain);
  Net net;
  net.g_W = {0, -9.81, 0};
  Net::Points points;
  for (int i = 0; i <= 12; ++i) {
    net.mass.push_back(i == 0 || i == 12 ? 0 : 0.1);
    points.push_back(
        {0.8 * i / 12, i == 0 || i == 12 ? 0 : -0.05 - 0.01 * (i % 3), 0.02 * (i % 2)});
    if (i > 0) net.links.push_back({i - 1, i, 300, 0.1});
  }
  points.front().z() = points.back().z() = 0;
  points = net.Minimum(points);
  for (std::size_t i = 0; i < catenary.points_W.size(); ++i)
    EXPECT_LE((points[i + 1] - catenary.points_W[i]).norm(), 1e-11);
  // The Hessian is the derivative of the gradient, and the gradient that of the energy.
  Net::Points moved = points;
  moved[3] += Eigen::Vector3d(1e-6, -2e-6, 3e-6);
  const Eigen::VectorXd slope = net.GradientAt(moved) - net.GradientAt(points);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(slope.size());
  step.segment<3>(6) = moved[3] - points[3];
  EXPECT_LE((net.HessianAt(points) * step - slope).norm(), 1e-4 * slope.norm());
}

TEST(Net, OneMassDecaysAsItsOscillator) {
  Net net;
  net.g_W = {0, -9.81, 0};
  net.mass = {0, 2};
  net.links.push_back({0, 1, 200, 1});
  const Net::Points rest = net.Minimum({{0, 0, 0}, {0.3, -1, 0.1}});
  EXPECT_NEAR(rest[1].y(), -1 - 2 * 9.81 / 200, 1e-12);
  // The pendulum motion across the spring is the slowest: ω² = g/L.
  const double w2 = 9.81 / 1.0981;
  EXPECT_NEAR(net.DecayAbout(rest, 1).Slowest(), 0.5, 1e-12);
  EXPECT_NEAR(net.DecayAbout(rest, 10).Slowest(), 5 - std::sqrt(25 - w2), 1e-9);
}

// ẍ = −ω² x − 2 γ ẋ from any start of size 1 in (x, ẋ/ω), by its closed form.
TEST(Decay, BoundsWhatRemainsOfEveryStart) {
  const double w = 3;
  for (const double g : {0.02, 1.0, 2.9, 2.9999999, 3.1, 8.0}) {
    const Decay decay{g, {w * w}};
    double largest_share = 0;
    for (int i = 0; i <= 400; ++i) {
      const double t = 0.01 * i;
      const std::complex<double> m = std::sqrt(std::complex<double>(g * g - w * w));
      const double C = std::cosh(m * t).real();
      const double S = (std::sinh(m * t) / m).real();
      double left = 0;
      for (int k = 0; k < 360; ++k) {
        const double x = std::cos(k * std::numbers::pi / 360);
        const double u = std::sin(k * std::numbers::pi / 360);
        left = std::max(left, std::exp(-g * t) * std::hypot(C * x + S * (g * x + w * u),
                                                            C * u - S * (w * x + g * u)));
      }
      EXPECT_LE(left, decay.LeftAfter(t) * (1 + 1e-9)) << g << " " << t;
      largest_share = std::max(largest_share, left / decay.LeftAfter(t));
    }
    EXPECT_GT(largest_share, 0.999) << g;
  }
}

TEST(Decay, IsFiniteForLongTimes) {
  EXPECT_NEAR((Decay{4, {1}}.LeftAfter(200)),
              4 / std::sqrt(15.) * std::exp((std::sqrt(15.) - 4) * 200), 1e-18);
}

/** Ten particles on springs, between (0, 2, 0) and (0.7, 1.9, 0.4). */
World Chain(double damping) {
  World world;
  world.gravity_W = {0, -9.81, 0};
  const Eigen::Vector3d from(0, 2, 0);
  const Eigen::Vector3d to(0.7, 1.9, 0.4);
  for (int i = 0; i < 10; ++i) {
    world.particles.push_back({"bead" + std::to_string(i),
                               from + (i + 1) / 11.0 * (to - from),
                               {0, 0, 0},
                               0.05,
                               damping,
                               0});
    world.springs.push_back({i == 0 ? Anchor{AnchorKind::kWorld, -1, from}
                                    : Anchor{AnchorKind::kParticle, i - 1, {0, 0, 0}},
                             {AnchorKind::kParticle, i, {0, 0, 0}},
                             200,
                             0,
                             0.1});
  }
  world.springs.push_back(
      {{AnchorKind::kParticle, 9, {0, 0, 0}}, {AnchorKind::kWorld, -1, to}, 200, 0, 0.1});
  world.dt = 1e-3;
  world.steps = 8000;
  world.sample_every = 100;
  return world;
}

/** Semi-implicit Euler of the springs, with `stiffer` times their stiffness. */
Trajectory Settled(const World& world, double stiffer = 1) {
  return Stepped(world, [&world, stiffer](WorldState& state) {
    std::vector<Eigen::Vector3d> force(world.particles.size(), Eigen::Vector3d::Zero());
    for (const Spring& spring : world.springs) {
      const Eigen::Vector3d arm =
          StateOf(world, state, spring.B).p_W - StateOf(world, state, spring.A).p_W;
      const Eigen::Vector3d pull = stiffer * spring.stiffness *
                                   (arm.norm() - spring.rest_length) * arm.normalized();
      for (const auto& [end, sign] :
           {std::pair(spring.A, 1.0), std::pair(spring.B, -1.0)}) {
        if (end.on == AnchorKind::kParticle)
          force[static_cast<std::size_t>(end.index)] += sign * pull;
      }
    }
    for (std::size_t i = 0; i < force.size(); ++i) {
      PointState& is = state.particles[i];
      const Particle& particle = world.particles[i];
      is.v_W = (is.v_W + world.dt * (world.gravity_W + force[i] / particle.mass)) *
               std::exp(-particle.damping * world.dt);
      is.p_W += world.dt * is.v_W;
    }
  });
}

std::vector<std::string> Beads() {
  std::vector<std::string> names;
  names.reserve(10);
  for (int i = 0; i < 10; ++i) names.push_back("bead" + std::to_string(i));
  return names;
}

TEST(HangsAsCatenary, ASettledChainPassesAndAStifferOneDoesNot) {
  const World world = Chain(6);
  const Claim claim = ClaimOf("hangs_as_catenary", Beads());
  const std::vector<LawFinding> findings = Judge(world, Settled(world), claim);
  EXPECT_TRUE(Passes(findings));
  EXPECT_LE(Of(findings, MeasureKind::kPositionError).tolerance.value, 1e-6);
  EXPECT_TRUE(
      Finds(Judge(world, Settled(world, 1.01), claim), MeasureKind::kPositionError));
}

TEST(HangsAsCatenary, RefusesUndampedMotionAndSubjectsThatAreNoChain) {
  EXPECT_EQ(FaultsOf(Chain(0), ClaimOf("hangs_as_catenary", Beads())).size(), 1U);
  std::vector<std::string> shuffled = Beads();
  std::swap(shuffled[2], shuffled[5]);
  EXPECT_EQ(FaultsOf(Chain(6), ClaimOf("hangs_as_catenary", shuffled)).size(), 1U);
}

TEST(HangsAsCatenary, ARodChainAtRestPassesAndASinkingOneDoesNot) {
  World world;
  world.gravity_W = {0, -9.81, 0};
  const Catenary rest = CatenaryOf(EqualChain(10, 0.1, 0.6, 0.05, kInfinite));
  for (int i = 0; i < 9; ++i) {
    world.bodies.push_back(BodyOf("bead" + std::to_string(i), Sphere{0.02}, 0.05,
                                  rest.points_W[static_cast<std::size_t>(i)]));
    world.joints.push_back({i == 0 ? Anchor{AnchorKind::kWorld, -1, {0, 0, 0}}
                                   : Anchor{AnchorKind::kBody, i - 1, {0, 0, 0}},
                            {AnchorKind::kBody, i, {0, 0, 0}},
                            0.1});
  }
  world.joints.push_back(
      {{AnchorKind::kBody, 8, {0, 0, 0}}, {AnchorKind::kWorld, -1, {0.6, 0, 0}}, 0.1});
  std::vector<std::string> beads = Beads();
  beads.pop_back();
  const Claim claim = ClaimOf("hangs_as_catenary", beads,
                              {{"from", 0},
                               {"expected_horizontal_tension", 0.799083227},
                               {"expected_largest_tension", 2.347442559},
                               {"expected_sag", 0.365545036}});
  const auto still = [](WorldState&) {};
  EXPECT_TRUE(Passes(Judge(world, Stepped(world, still), claim)));
  Trajectory sinks = Stepped(world, still);
  for (std::size_t s = 0; s < sinks.samples.size(); ++s)
    sinks.samples[s].bodies[4].p_WB.y() -= 1e-3 * sinks.times[s];
  EXPECT_TRUE(Finds(Judge(world, sinks, claim), MeasureKind::kPositionError));
}

TEST(MinimumEnergy, ASettledChainPassesAndOneThatStillMovesDoesNot) {
  const World world = Chain(6);
  const Claim claim = ClaimOf("minimum_energy");
  EXPECT_TRUE(Passes(Judge(world, Settled(world), claim)));
  EXPECT_TRUE(
      Finds(Judge(world, Settled(world, 1.01), claim), MeasureKind::kPositionError));
  Trajectory moving = Settled(world);
  for (PointState& bead : moving.samples.back().particles) bead.v_W.x() += 1e-2;
  EXPECT_TRUE(Finds(Judge(world, moving, claim), MeasureKind::kEnergyDrift));
}

/** A bead between two walls 2 m apart, on springs too long for the distance: it can hang,
 or be propped up. */
World ProppedBead(double height) {
  World world;
  world.gravity_W = {0, -9.81, 0};
  world.particles = {{"bead", {0, height, 0}, {0, 0, 0}, 0.1, 6, 0}};
  for (const double x : {-1.0, 1.0})
    world.springs.push_back({{AnchorKind::kWorld, -1, {x, 0, 0}},
                             {AnchorKind::kParticle, 0, {0, 0, 0}},
                             200,
                             0,
                             1.2});
  world.dt = 1e-3;
  world.steps = 8000;
  world.sample_every = 100;
  return world;
}

TEST(MinimumEnergy, FindsABeadThatRestsInAHigherMinimum) {
  const World hanging = ProppedBead(-0.3);
  EXPECT_TRUE(Passes(Judge(hanging, Settled(hanging), ClaimOf("minimum_energy"))));
  // It comes to rest too, 1.3 m higher: that minimum is not the lowest.
  Trajectory propped = Settled(ProppedBead(0.3));
  ASSERT_GT(propped.samples.back().particles[0].p_W.y(), 0.6);
  const std::vector<LawFinding> findings =
      Judge(hanging, propped, ClaimOf("minimum_energy"));
  EXPECT_TRUE(Finds(findings, MeasureKind::kPositionError));
  EXPECT_TRUE(Finds(findings, MeasureKind::kEnergyDrift));
}

/** A bead released at `height` [m] below a minimum that props it up and is the higher
 one. */
World BistableBead(double height, double speed) {
  World world;
  world.gravity_W = {0, -1, 0};
  world.particles = {{"bead", {0, height, 0}, {0, speed, 0}, 1, 2, 0}};
  for (const double x : {-0.4, 0.4})
    world.springs.push_back({{AnchorKind::kWorld, -1, {x, 0, 0}},
                             {AnchorKind::kParticle, 0, {0, 0, 0}},
                             100,
                             0,
                             0.5});
  world.dt = 1e-3;
  world.steps = 20000;
  world.sample_every = 200;
  return world;
}

TEST(MinimumEnergy, ABeadThatSwingsOverAHumpRestsBeyondIt) {
  const Claim claim = ClaimOf("minimum_energy");
  const World over = BistableBead(-0.55, 0);
  const Trajectory swung = Settled(over);
  ASSERT_GT(swung.samples.back().particles[0].p_W.y(), 0.28);
  EXPECT_TRUE(Passes(Judge(over, swung, claim)));
  // From a smaller depth it stays in the lower minimum, and the upper one is wrong.
  const World under = BistableBead(-0.45, 0);
  const Trajectory stayed = Settled(under);
  ASSERT_LT(stayed.samples.back().particles[0].p_W.y(), -0.28);
  EXPECT_TRUE(Passes(Judge(under, stayed, claim)));
  EXPECT_TRUE(Finds(Judge(under, swung, claim), MeasureKind::kPositionError));
}

TEST(MinimumEnergy, AllowsTheRemainderOfAnInitialVelocity) {
  const World thrown = BistableBead(-0.3, 1.8);
  EXPECT_TRUE(Passes(Judge(thrown, Settled(thrown), ClaimOf("minimum_energy"))));
}

TEST(RestAfter, IsTheRestOfADampedSpringAndUnknownForATooLongMotion) {
  Net net;
  net.g_W = {0, -9.81, 0};
  net.mass = {0, 2};
  net.links.push_back({0, 1, 200, 1, 3});
  const std::vector<double> drag = {0, 0.5};
  const Net::Points start = {{0, 0, 0}, {0, -1.4, 0}};
  const Net::Points still(2, Eigen::Vector3d::Zero());
  const auto rest = RestAfter(net, drag, start, still, 3);
  ASSERT_TRUE(rest);
  EXPECT_NEAR((*rest)[1].y(), -1 - 2 * 9.81 / 200, 1e-12);
  EXPECT_FALSE(RestAfter(net, drag, start, still, 1e9));
}

TEST(MinimumEnergy, AcceptsEitherMirrorImage) {
  // Without gravity both minima are equally deep.
  World world = ProppedBead(-0.3);
  world.gravity_W.setZero();
  World image = ProppedBead(0.3);
  image.gravity_W.setZero();
  EXPECT_TRUE(Passes(Judge(world, Settled(image), ClaimOf("minimum_energy"))));
}

TEST(MinimumEnergy, AClothRestsWhereTheMinimiserPutsIt) {
  World world;
  world.gravity_W = {0, -9.81, 0};
  Cloth cloth;
  cloth.name = "sail";
  cloth.n = 4;
  cloth.spacing = 0.2;
  cloth.node_mass = 0.05;
  cloth.damping = 4;
  cloth.structural = cloth.shear = {300, 0};
  cloth.bend = {30, 0};
  cloth.pinned = {{0, 0}, {0, 3}};
  world.cloths = {cloth};
  world.dt = 1e-3;
  world.steps = 20000;
  world.sample_every = 1000;
  const std::vector<ClothSpring> springs = SpringsOf(cloth);
  const auto settle = [&](double stiffer) {
    return Stepped(world, [&, stiffer](WorldState& state) {
      std::vector<Eigen::Vector3d> force(16, Eigen::Vector3d::Zero());
      for (const ClothSpring& spring : springs) {
        const auto a = static_cast<std::size_t>(spring.a);
        const auto b = static_cast<std::size_t>(spring.b);
        const Eigen::Vector3d arm = state.nodes[b].p_W - state.nodes[a].p_W;
        const Eigen::Vector3d pull = stiffer * spring.stiffness *
                                     (arm.norm() - spring.rest_length) * arm.normalized();
        force[a] += pull;
        force[b] -= pull;
      }
      for (std::size_t i = 0; i < 16; ++i) {
        if (IsPinned(cloth, static_cast<int>(i))) continue;
        PointState& is = state.nodes[i];
        is.v_W = (is.v_W + world.dt * (world.gravity_W + force[i] / 0.05)) *
                 std::exp(-4 * world.dt);
        is.p_W += world.dt * is.v_W;
      }
    });
  };
  EXPECT_TRUE(Passes(Judge(world, settle(1), ClaimOf("minimum_energy"))));
  EXPECT_TRUE(Finds(Judge(world, settle(1.02), ClaimOf("minimum_energy")),
                    MeasureKind::kPositionError));
  world.cloths[0].damping = 0;
  EXPECT_EQ(FaultsOf(world, ClaimOf("minimum_energy")).size(), 1U);
}

TEST(TurnsOnce, hangs_as_catenary) {
  const World world = Chain(6);
  EXPECT_TRUE(TurnsOnce(world, Settled(world), ClaimOf("hangs_as_catenary", Beads())));
}

TEST(TurnsOnce, minimum_energy) {
  const World world = Chain(6);
  EXPECT_TRUE(TurnsOnce(world, Settled(world), ClaimOf("minimum_energy")));
}

}  // namespace
}  // namespace touchstone
