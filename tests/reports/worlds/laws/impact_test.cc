#include "reports/worlds/truth/impact.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "reports/worlds/truth/row_of_balls.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kPi = std::numbers::pi;

double Uniform(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

/** Routh's impact in increments dJ_n: friction opposes the current slip, and restitution
 returns e times the impulse of compression. */
Eigen::Vector3d Incremental(const Eigen::Matrix3d& K, Eigen::Vector3d u, double e,
                            double mu, int steps) {
  // The normal is z.
  Eigen::Vector3d J = Eigen::Vector3d::Zero();
  const double dJ = -u.z() / K(2, 2) / steps;
  double end = -1;
  while (end < 0 || J.z() < end) {
    // Slip that friction would reverse within the increment is stopped instead.
    Eigen::Vector2d hold = -K.topLeftCorner<2, 2>().inverse() *
                           (u.head<2>() + K.topRightCorner<2, 1>() * dJ);
    if (hold.norm() > mu * dJ) hold *= mu * dJ / hold.norm();
    const Eigen::Vector3d step(hold.x(), hold.y(), dJ);
    J += step;
    u += K * step;
    if (end < 0 && u.z() >= 0) end = (1 + e) * J.z();
  }
  return J;
}

RC_GTEST_PROP(CentralImpulse, IsRouthsImpactOfTwoSpheres, ()) {
  const double k_n = Uniform(0.2, 3);
  const double k_t = k_n * Uniform(1.5, 4);
  const Eigen::Matrix3d K = Eigen::Vector3d(k_t, k_t, k_n).asDiagonal();
  const Eigen::Vector3d u(Uniform(-3, 3), Uniform(-3, 3), -Uniform(0.1, 3));
  const double e = Uniform(0, 1);
  const double mu = Uniform(0, 1);
  const Eigen::Vector3d n(0, 0, 1);
  const Eigen::Vector3d J = CentralImpulse(K, u, n, e, mu, ConesOn(n).front());
  RC_ASSERT((Incremental(K, u, e, mu, 2000) - J).norm() <= 4e-3 * J.norm());
}

Eigen::Matrix2d RandomResponse() {
  Eigen::Matrix2d half;
  half << Uniform(0.5, 2), Uniform(-1, 1), Uniform(-1, 1), Uniform(0.5, 2);
  return half * half.transpose() + 0.05 * Eigen::Matrix2d::Identity();
}

RC_GTEST_PROP(PlanarImpulse, ByPoissonIsRouthsImpact, ()) {
  const Eigen::Matrix2d K = RandomResponse();
  const InPlane u(-Uniform(0.1, 2), Uniform(-2, 2));
  const double e = Uniform(0, 1);
  const double mu = Uniform(0, 1);
  InPlane J = InPlane::Zero();
  InPlane at = u;
  const double dJ = -u.x() / K(0, 0) / 5000;
  double end = -1;
  while (end < 0 || J.x() < end) {
    const double hold = -(at.y() + K(1, 0) * dJ) / K(1, 1);
    const InPlane step(dJ, std::clamp(hold, -mu * dJ, mu * dJ));
    J += step;
    at += K * step;
    if (end < 0 && at.x() >= 0) end = (1 + e) * J.x();
  }
  RC_ASSERT((PlanarImpulse(ImpactRule::kPoisson, K, u, e, mu) - J).norm() <=
            2e-3 * J.norm());
}

RC_GTEST_PROP(PlanarImpulse, ByNewtonReflectsAndOpposesTheRemainingSlip, ()) {
  const Eigen::Matrix2d K = RandomResponse();
  const InPlane u(-Uniform(0.1, 2), Uniform(-2, 2));
  const double e = Uniform(0, 1);
  // Above that bound both directions of slip may be right, or none (Painlevé).
  const double mu = Uniform(0, 0.9) * K(1, 1) / std::max(1e-9, std::abs(K(0, 1))) *
                    std::min(1.0, K(0, 0) / K(1, 1));
  const InPlane J = PlanarImpulse(ImpactRule::kNewton, K, u, e, mu);
  const InPlane after = u + K * J;
  RC_ASSERT(std::abs(after.x() + e * u.x()) <= 1e-12 * (1 + J.norm()));
  RC_ASSERT(std::abs(J.y()) <= mu * J.x() * (1 + 1e-12));
  if (std::abs(after.y()) > 1e-9) {
    RC_ASSERT(after.y() * J.y() <= 0);
    RC_ASSERT(std::abs(std::abs(J.y()) - mu * J.x()) <= 1e-12 * J.norm());
  }
}

TEST(PlanarImpulse, BothRulesAgreeWithoutCoupling) {
  Eigen::Matrix2d K;
  K << 1.3, 0, 0, 2.1;
  for (const double mu : {0.0, 0.2, 0.9}) {
    EXPECT_LE((PlanarImpulse(ImpactRule::kNewton, K, {-2, 1.5}, 0.6, mu) -
               PlanarImpulse(ImpactRule::kPoisson, K, {-2, 1.5}, 0.6, mu))
                  .norm(),
              1e-14);
  }
}

std::vector<RowBall> TouchingRow(int n, double gap = 0) {
  std::vector<RowBall> balls;
  balls.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
    balls.push_back({1, 0.1, i * (0.2 + gap), i == 0 ? 1.0 : 0});
  return balls;
}

TEST(RowOfBalls, MatchesTheCradleForSequentialAndSimultaneousImpacts) {
  for (const double gap : {0.0, 1e-3}) {
    const RowOfBalls in_order(TouchingRow(5, gap), {1, 1, 1, 1}, 1e-9,
                              RowRule::kFromFirst);
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(in_order.last()[static_cast<std::size_t>(i)].v, i == 4, 1e-14);
    EXPECT_NEAR(in_order.end(), 4 * gap, 1e-14);
  }
  // v₁ = (1 − (N−1) e)/N, the others (1 + e)/N.
  for (const double e : {0.0, 0.5, 1.0}) {
    const RowOfBalls at_once(TouchingRow(5), {e, e, e, e}, 1e-9, RowRule::kSimultaneous);
    EXPECT_NEAR(at_once.last()[0].v, (1 - 4 * e) / 5, 1e-12);
    for (int i = 1; i < 5; ++i)
      EXPECT_NEAR(at_once.last()[static_cast<std::size_t>(i)].v, (1 + e) / 5, 1e-12);
  }
}

TEST(RowOfBalls, PassesOnAFractionOfTheSpeedAtEachGap) {
  const double e = 0.8;
  const RowOfBalls row(TouchingRow(4, 0.5), {e, e, e}, 1e-9, RowRule::kFromFirst);
  EXPECT_NEAR(row.last()[3].v, std::pow((1 + e) / 2, 3), 1e-14);
}

TEST(RowOfBalls, ConservesMomentumAndLosesTheEnergyOfRestitution) {
  const std::vector<RowBall> balls = {
      {1, 0.1, 0, 2}, {3, 0.2, 0.5, 0.3}, {0.5, 0.1, 1, -1}, {2, 0.1, 1.5, -1.4}};
  const auto sums = [](const std::vector<RowBall>& row) {
    double momentum = 0;
    double energy = 0;
    for (const RowBall& ball : row) {
      momentum += ball.mass * ball.v;
      energy += ball.mass * ball.v * ball.v / 2;
    }
    return std::pair(momentum, energy);
  };
  for (const double e : {0.4, 1.0}) {
    const RowOfBalls row(balls, {e, e, e}, 1e-9, RowRule::kFromFirst);
    EXPECT_NEAR(sums(row.last()).first, sums(balls).first, 1e-13);
    if (e == 1) {
      EXPECT_NEAR(sums(row.last()).second, sums(balls).second, 1e-13);
    } else {
      EXPECT_LT(sums(row.last()).second, sums(balls).second);
    }
    for (const double t : {0.1, 0.3, 2.0}) {
      const std::vector<RowBall> at = row.At(t);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_GE(at[i + 1].x - at[i].x, at[i].radius + at[i + 1].radius - 1e-12);
    }
  }
}

/** The rules by which the engine of these tests resolves impacts. */
struct Impacts {
  FrictionCone cone = FrictionCone::kCircle;
  bool at_once = false;    ///< All contacts as one equation.
  double restitution = 1;  ///< Multiplies the restitution of the bodies.
  double friction = 1;     ///< Multiplies the friction of the bodies.
  double inset = 0;        ///< Depth of the contact points, over the overlap.
};

struct Touch {
  std::size_t A;
  std::size_t B;
  Eigen::Vector3d n_W;
  Eigen::Vector3d p_W;
  double target;
  double J_n = 0;
};

/** Moreau's scheme for spheres, and for one static half-space y = 0 if the last body is
 one. Contacts that overlap at the start of the step are resolved, then the bodies
 move. */
Trajectory Struck(const World& world, const Impacts& impacts) {
  return Stepped(world, [&world, impacts](WorldState& state) {
    const std::size_t n = world.bodies.size();
    const auto radius = [&](std::size_t i) {
      return std::get<Sphere>(world.bodies[i].placed.shape).radius;
    };
    const auto striker = [&](std::size_t i) {
      const RigidBody& body = world.bodies[i];
      Striker is;
      is.p_WB = state.bodies[i].p_WB;
      is.v_WB = state.bodies[i].v_WB;
      is.w_WB = state.bodies[i].w_WB;
      if (body.mass == 0) return is;
      is.inverse_mass = 1 / body.mass;
      is.inverse_inertia_W = Eigen::Matrix3d::Identity() / InertiaOf(body).x();
      return is;
    };
    const auto strike = [&](const Touch& touch, const Eigen::Vector3d& J_W) {
      for (const auto& [i, sign] : {std::pair(touch.A, -1.0), std::pair(touch.B, 1.0)}) {
        Striker is = striker(i);
        is.Strike(sign * J_W, touch.p_W);
        state.bodies[i].v_WB = is.v_WB;
        state.bodies[i].w_WB = is.w_WB;
      }
    };
    const auto slip = [&](const Touch& touch) {
      return Eigen::Vector3d(striker(touch.B).VelocityAt(touch.p_W) -
                             striker(touch.A).VelocityAt(touch.p_W));
    };
    std::vector<Touch> touches;
    for (std::size_t A = 0; A < n; ++A) {
      const bool plane = std::holds_alternative<HalfSpace>(world.bodies[A].placed.shape);
      for (std::size_t B = plane ? 0 : A + 1; B < n; ++B) {
        if (std::holds_alternative<HalfSpace>(world.bodies[B].placed.shape)) continue;
        const Eigen::Vector3d p_W = state.bodies[B].p_WB - state.bodies[A].p_WB;
        const Eigen::Vector3d n_W = plane ? Eigen::Vector3d::UnitY() : p_W.normalized();
        const double gap =
            plane ? p_W.y() - radius(B) : p_W.norm() - radius(A) - radius(B);
        if (gap > 1e-12) continue;
        Touch touch{A, B, n_W,
                    state.bodies[B].p_WB - (radius(B) + impacts.inset * gap) * n_W, 0};
        const double u_n = n_W.dot(slip(touch));
        const double e =
            std::min(world.bodies[A].restitution, world.bodies[B].restitution);
        touch.target = -impacts.restitution * e * std::min(0.0, u_n);
        touches.push_back(touch);
      }
    }
    for (BodyState& body : state.bodies) {
      const auto i = static_cast<std::size_t>(&body - state.bodies.data());
      if (world.bodies[i].mass > 0) body.v_WB += world.dt * world.gravity_W;
    }
    if (impacts.at_once) {
      for (int iteration = 0; iteration < 2000; ++iteration) {
        for (Touch& touch : touches) {
          const Eigen::Matrix3d K = ImpulseResponse(striker(touch.A), touch.p_W) +
                                    ImpulseResponse(striker(touch.B), touch.p_W);
          const double J_n =
              std::max(0.0, touch.J_n + (touch.target - touch.n_W.dot(slip(touch))) /
                                            touch.n_W.dot(K * touch.n_W));
          strike(touch, (J_n - touch.J_n) * touch.n_W);
          touch.J_n = J_n;
        }
      }
    } else {
      for (int iteration = 0; iteration < 200; ++iteration) {
        for (const Touch& touch : touches) {
          const Eigen::Vector3d u = slip(touch);
          const double e =
              impacts.restitution * std::min(world.bodies[touch.A].restitution,
                                             world.bodies[touch.B].restitution);
          const double mu = impacts.friction * std::sqrt(world.bodies[touch.A].friction *
                                                         world.bodies[touch.B].friction);
          const Eigen::Matrix3d K = ImpulseResponse(striker(touch.A), touch.p_W) +
                                    ImpulseResponse(striker(touch.B), touch.p_W);
          for (const PlacedCone& cone : ConesOn(touch.n_W)) {
            if (cone.cone != impacts.cone) continue;
            strike(touch, CentralImpulse(K, u, touch.n_W, e, mu, cone));
            break;
          }
        }
      }
    }
    for (BodyState& body : state.bodies) body.p_WB += world.dt * body.v_WB;
  });
}

World Cradle(double gap, double e = 1, double dt = 1e-3) {
  World world;
  const Eigen::Vector3d d = Eigen::Vector3d(1, 2, -0.5).normalized();
  for (int i = 0; i < 5; ++i) {
    RigidBody ball =
        BodyOf("ball" + std::to_string(i), Sphere{0.1}, 0.7,
               Eigen::Vector3d(0.3, 0.1, 0) + (i == 0 ? -0.1 : i * (0.2 + gap)) * d);
    ball.restitution = e;
    world.bodies.push_back(ball);
  }
  world.bodies[0].v_WB = 1.5 * d;
  world.gravity_W.setZero();
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(0.6 / dt));
  return world;
}

TEST(RowImpact, SequentialImpactsPass) {
  for (const double dt : {1.0 / 240, 1e-3}) {
    for (const double gap : {0.0, 0.02}) {
      const World world = Cradle(gap, 1, dt);
      EXPECT_TRUE(Passes(Judge(world, Struck(world, {}),
                               ClaimOf("row_impact", {},
                                       {{"expected_last_velocity", 1.5},
                                        {"expected_simultaneous_first_"
                                         "velocity",
                                         gap == 0 ? -0.9 : 0}}))))
          << dt << " " << gap;
    }
  }
}

TEST(RowImpact, RecognisesSimultaneousImpacts) {
  for (const double e : {0.5, 1.0}) {
    const World world = Cradle(0, e);
    Impacts impacts;
    impacts.at_once = true;
    const LawFinding finding =
        Of(Judge(world, Struck(world, impacts), ClaimOf("row_impact")),
           MeasureKind::kVelocityError);
    EXPECT_GT(finding.value, finding.tolerance.value);
    EXPECT_EQ(finding.recognised, "simultaneous impacts");
  }
}

// Compared with sequential impacts, the first ball would be off by 0.9 m/s.
TEST(RowImpact, ComparesAMotionThatFollowsNoRuleWithTheNearest) {
  const World world = Cradle(0);
  Impacts impacts;
  impacts.at_once = true;
  Trajectory motion = Struck(world, impacts);
  for (WorldState& state : motion.samples) state.bodies[4].v_WB *= 0.999;
  const LawFinding finding =
      Of(Judge(world, motion, ClaimOf("row_impact")), MeasureKind::kVelocityError);
  EXPECT_EQ(finding.recognised, "");
  EXPECT_NEAR(finding.value, 0.001 * 0.4 * 1.5, 1e-6);
  EXPECT_THAT(finding.proof,
              testing::HasSubstr("after simultaneous impacts it moves at"));
}

TEST(RowImpact, FindsTooLittleRestitution) {
  const World world = Cradle(0.02, 1);
  Impacts impacts;
  impacts.restitution = 0.99;
  EXPECT_TRUE(Finds(Judge(world, Struck(world, impacts), ClaimOf("row_impact")),
                    MeasureKind::kVelocityError));
}

TEST(RowImpact, JudgesABallBetweenTwoImpactsOfTheRow) {
  // The second ball is at rest again while the wave moves on to the fifth.
  const World world = Cradle(0.1);
  Trajectory creeping = Struck(world, {});
  EXPECT_TRUE(Passes(Judge(world, creeping, ClaimOf("row_impact"))));
  const std::size_t s = 250;
  ASSERT_NEAR(creeping.samples[s].bodies[1].v_WB.norm(), 0, 1e-9);
  ASSERT_GT(creeping.samples[s].bodies[3].v_WB.norm() +
                creeping.samples[s].bodies[2].v_WB.norm(),
            1.4);
  creeping.samples[s].bodies[1].v_WB.x() += 0.01;
  EXPECT_TRUE(
      Finds(Judge(world, creeping, ClaimOf("row_impact")), MeasureKind::kVelocityError));
}

TEST(RowImpact, RefusesAnImpactThatNoSampleShows) {
  World world = Cradle(0.02);
  world.steps = 81;  // The first two meet after 0.12 m at 1.5 m/s: 80 steps.
  EXPECT_EQ(FaultsOf(world, ClaimOf("row_impact")).size(), 1U);
}

TEST(RowImpact, RefusesSubjectsThatAreNoRow) {
  World world = Cradle(0.02);
  EXPECT_EQ(FaultsOf(world, ClaimOf("row_impact", {"ball0", "ball2", "ball1"})).size(),
            1U);
  world.bodies[2].placed.X_WB.p_WB.z() += 0.01;
  EXPECT_EQ(FaultsOf(world, ClaimOf("row_impact")).size(), 1U);
  world = Cradle(0.02);
  world.bodies[0].v_WB *= -1;
  EXPECT_EQ(FaultsOf(world, ClaimOf("row_impact")).size(), 1U);
}

/** A row of the published table: m = 1, r = 0.5, 5 m/s at `incidence` from the normal. */
World Oblique(double e, double mu, double incidence, double dt = 1e-3,
              double gravity = 0) {
  World world;
  const double at = incidence * kPi / 180;
  // Rotated about the normal, so that the motion is along no world axis.
  const Eigen::AngleAxisd turn(0.4, Eigen::Vector3d::UnitY());
  RigidBody ball = BodyOf("ball", Sphere{0.5}, 1, {0, 1.2, 0});
  ball.v_WB = turn * Eigen::Vector3d(5 * std::sin(at), -5 * std::cos(at), 0);
  ball.restitution = e;
  ball.friction = mu;
  RigidBody ground = GroundOf();
  ground.restitution = 1;
  ground.friction = mu;
  world.bodies = {ball, ground};
  world.gravity_W = {0, -gravity, 0};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(0.6 / dt));
  return world;
}

TEST(SphereImpactOnAPlane, KnowsThePublishedTable) {
  struct Row {
    double e, mu, incidence, v_x, v_z, w, ratio;
  };
  for (const Row& row : {Row{1, .1, 45, 2.828427, 3.535534, 3.535534, 0.870000},
                         Row{1, .5, 45, 2.525381, 3.535534, 5.050763, 0.857143},
                         Row{.8, .2, 60, 3.430127, 2.000000, 4.500000, 0.711631},
                         Row{.8, .3, 30, 1.785714, 3.464102, 3.571429, 0.658571}}) {
    const World world = Oblique(row.e, row.mu, row.incidence);
    EXPECT_TRUE(FaultsOf(world, ClaimOf("sphere_impact", {},
                                        {{"expected_tangential_speed", row.v_x},
                                         {"expected_normal_speed", row.v_z},
                                         {"expected_spin", row.w},
                                         {"expected_energy_ratio", row.ratio}}))
                    .empty());
  }
}

TEST(SphereImpactOnAPlane, AMotionByTheRulePasses) {
  for (const double dt : {1.0 / 60, 1.0 / 240, 1e-3}) {
    for (const double gravity : {0.0, 9.82}) {
      for (const double inset : {0.0, 0.5, 1.0}) {
        for (const double mu : {0.1, 0.5}) {
          const World world = Oblique(0.8, mu, 50, dt, gravity);
          Impacts impacts;
          impacts.inset = inset;
          EXPECT_TRUE(
              Passes(Judge(world, Struck(world, impacts), ClaimOf("sphere_impact"))))
              << dt << " " << gravity << " " << inset << " " << mu;
        }
      }
    }
  }
}

TEST(SphereImpactOnAPlane, RecognisesTheOtherCones) {
  const World world = Oblique(0.8, 0.2, 60);
  for (const FrictionCone cone : {FrictionCone::kBox, FrictionCone::kDiamond}) {
    Impacts impacts;
    impacts.cone = cone;
    EXPECT_EQ(Of(Judge(world, Struck(world, impacts), ClaimOf("sphere_impact")),
                 MeasureKind::kVelocityError)
                  .recognised,
              NameOf(cone));
  }
}

TEST(SphereImpactOnAPlane, FindsWrongFrictionAndRestitution) {
  const World world = Oblique(0.8, 0.2, 60);
  Impacts impacts;
  impacts.friction = 0.97;
  EXPECT_TRUE(Finds(Judge(world, Struck(world, impacts), ClaimOf("sphere_impact")),
                    MeasureKind::kSpinError));
  impacts = {};
  impacts.restitution = 0.99;
  EXPECT_TRUE(Finds(Judge(world, Struck(world, impacts), ClaimOf("sphere_impact")),
                    MeasureKind::kRestitution));
}

TEST(SphereImpactOnAPlane, RefusesASphereThatNeverArrives) {
  World world = Oblique(0.8, 0.2, 60);
  world.bodies[0].v_WB *= -1;
  EXPECT_EQ(FaultsOf(world, ClaimOf("sphere_impact")).size(), 1U);
  world = Oblique(0.8, 0.2, 60);
  world.steps = 10;
  EXPECT_EQ(FaultsOf(world, ClaimOf("sphere_impact")).size(), 1U);
  world = Oblique(0, 0.2, 60, 1e-3, 9.8);
  EXPECT_EQ(FaultsOf(world, ClaimOf("sphere_impact")).size(), 1U);
}

World TwoSpheres(double dt = 1e-3) {
  World world;
  RigidBody A = BodyOf("left", Sphere{0.3}, 1.4, {0, 0.1, 0});
  RigidBody B = BodyOf("right", Sphere{0.2}, 0.6, {1.1, 0.3, -0.1});
  A.v_WB = {2, 0.3, 0};
  A.w_WB = {1, -4, 6};
  B.v_WB = {-1.5, 0.2, 0.4};
  B.w_WB = {-3, 2, 9};
  A.restitution = 0.7;
  B.restitution = 0.9;
  A.friction = 0.05;
  B.friction = 0.2;
  world.bodies = {A, B};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(0.5 / dt));
  return world;
}

TEST(SphereImpact, AMotionByTheRulePasses) {
  for (const double dt : {1.0 / 60, 1.0 / 240, 1e-3}) {
    for (const double inset : {0.0, 0.5, 1.0}) {
      const World world = TwoSpheres(dt);
      Impacts impacts;
      impacts.inset = inset;
      EXPECT_TRUE(Passes(Judge(world, Struck(world, impacts), ClaimOf("sphere_impact"))))
          << dt << " " << inset;
    }
  }
}

TEST(SphereImpact, FindsWrongFrictionRestitutionAndInertia) {
  const World world = TwoSpheres();
  Impacts impacts;
  impacts.friction = 0.8;
  EXPECT_TRUE(Finds(Judge(world, Struck(world, impacts), ClaimOf("sphere_impact")),
                    MeasureKind::kSpinError));
  impacts = {};
  impacts.restitution = 0.97;
  EXPECT_TRUE(Finds(Judge(world, Struck(world, impacts), ClaimOf("sphere_impact")),
                    MeasureKind::kRestitution));
  World heavy = world;
  heavy.bodies[1].inertia = 1.2 * InertiaOf(world.bodies[1]);
  EXPECT_TRUE(Finds(Judge(world, Struck(heavy, {}), ClaimOf("sphere_impact")),
                    MeasureKind::kSpinError));
}

TEST(SphereImpact, HeadOnSpheresHaveTheTextbookSpeeds) {
  // Jolt's MassOverride with equal scales: v₁' = (2 w₁ v₂ + (w₂ − w₁) v₁)/(w₁ + w₂).
  World world = TwoSpheres();
  for (RigidBody& body : world.bodies) {
    body.restitution = 1;
    body.w_WB.setZero();
  }
  world.bodies[0].mass = 1;
  world.bodies[1].mass = 2;
  world.bodies[0].v_WB = {3, 0, 0};
  world.bodies[1].v_WB = {-4, 0, 0};
  world.bodies[1].placed.X_WB.p_WB = {1, 0.1, 0};
  world.gravity_W.setZero();
  EXPECT_TRUE(FaultsOf(world, ClaimOf("sphere_impact", {"left", "right"},
                                      {{"expected_first_speed", 19.0 / 3},
                                       {"expected_second_speed", 2.0 / 3},
                                       {"expected_energy_ratio", 1}}))
                  .empty());
  world.bodies[1].placed.X_WB.p_WB.y() = 3;
  EXPECT_EQ(FaultsOf(world, ClaimOf("sphere_impact")).size(), 1U);
}

/** A box that falls on its lowest corner or edge. */
World Tumbling(const Eigen::Quaterniond& q_WB, double mu, double dt = 1e-3) {
  World world;
  RigidBody box = BodyOf("box", Box{{0.3, 0.1, 0.2}}, 2, {0, 0, 0});
  box.placed.X_WB = Pose::FromQuaternion({0.1, 0.8, -0.2}, q_WB);
  box.v_WB = {1.2, -2, 0};
  box.restitution = 0.6;
  box.friction = mu;
  RigidBody ground = GroundOf();
  ground.restitution = 1;
  ground.friction = mu;
  world.bodies = {box, ground};
  world.gravity_W = {0, -1, 0};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(0.6 / dt));
  return world;
}

const Eigen::Quaterniond kOnCorner = Eigen::Quaterniond(0.8, 0.3, 0.2, 0.4).normalized();
const Eigen::Quaterniond kOnEdge(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));

/** A box whose lowest corners are reflected by `rule` once, in the plane z = 0 if there
 is friction; it rotates by the explicit step of Euler's equations. */
Trajectory Tumbled(const World& world, ImpactRule rule, double restitution = 0.6) {
  return Stepped(world, [&world, rule, restitution](WorldState& state) {
    BodyState& is = state.bodies[0];
    const RigidBody& body = world.bodies[0];
    const double mu = body.friction;
    const Eigen::Matrix3d R = is.q_WB.toRotationMatrix();
    const Eigen::Matrix3d I = R * InertiaOf(body).asDiagonal() * R.transpose();
    Striker striker{1 / body.mass, I.inverse(), is.p_WB, is.v_WB, is.w_WB};
    Eigen::Vector3d lowest = Eigen::Vector3d::Zero();
    int count = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                 corner & 4 ? 1 : -1);
      const Eigen::Vector3d r =
          R * sign.cwiseProduct(std::get<Box>(body.placed.shape).half_extents);
      if (is.p_WB.y() + r.y() > 1e-12) continue;
      lowest += is.p_WB + r;
      ++count;
    }
    if (count > 0) {
      lowest /= count;
      const Eigen::Matrix3d K = ImpulseResponse(striker, lowest);
      const Eigen::Vector3d u = striker.VelocityAt(lowest);
      Eigen::Matrix<double, 3, 2> plane;
      plane << Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX();
      if (u.y() < 0) {
        striker.Strike(
            mu == 0 ? Eigen::Vector3d(0, -(1 + restitution) * u.y() / K(1, 1), 0)
                    : Eigen::Vector3d(
                          plane * PlanarImpulse(rule, plane.transpose() * K * plane,
                                                plane.transpose() * u, restitution, mu)),
            lowest);
      }
    }
    striker.v_WB += world.dt * world.gravity_W;
    striker.w_WB -= world.dt * I.inverse() * striker.w_WB.cross(I * striker.w_WB);
    is.v_WB = striker.v_WB;
    is.w_WB = striker.w_WB;
    is.p_WB += world.dt * is.v_WB;
    is.q_WB = Turned(is.q_WB, world.dt * is.w_WB);
  });
}

TEST(CornerImpact, AMotionByTheRulePasses) {
  for (const double dt : {1.0 / 240, 1e-3}) {
    const World corner = Tumbling(kOnCorner, 0, dt);
    EXPECT_TRUE(Passes(
        Judge(corner, Tumbled(corner, ImpactRule::kNewton), ClaimOf("corner_impact"))))
        << dt;
    const World edge = Tumbling(kOnEdge, 0.3, dt);
    EXPECT_TRUE(
        Passes(Judge(edge, Tumbled(edge, ImpactRule::kNewton), ClaimOf("corner_impact"))))
        << dt;
  }
}

TEST(CornerImpact, AcceptsACornerOfASquareRodWithFriction) {
  const Eigen::Quaterniond on_its_edge(
      Eigen::AngleAxisd(std::numbers::pi / 4, Eigen::Vector3d::UnitX()));
  World world = Tumbling(kOnEdge * on_its_edge, 0.3, 1e-4);
  EXPECT_FALSE(FaultsOf(world, ClaimOf("corner_impact")).empty());
  world.bodies[0].placed.shape = Box{{0.3, 0.1, 0.1}};
  EXPECT_TRUE(FaultsOf(world, ClaimOf("corner_impact")).empty());
  EXPECT_TRUE(Passes(
      Judge(world, Tumbled(world, ImpactRule::kNewton), ClaimOf("corner_impact"))));
  EXPECT_TRUE(Finds(
      Judge(world, Tumbled(world, ImpactRule::kNewton, 0.55), ClaimOf("corner_impact")),
      MeasureKind::kSpinError));
}

TEST(CornerImpact, RecognisesPoissonsRestitution) {
  World world = Tumbling(kOnEdge, 0.9);
  world.bodies[0].v_WB.x() = 3;
  const LawFinding finding =
      Of(Judge(world, Tumbled(world, ImpactRule::kPoisson), ClaimOf("corner_impact")),
         MeasureKind::kSpinError);
  EXPECT_GT(finding.value, finding.tolerance.value);
  EXPECT_EQ(finding.recognised, "Poisson's restitution");
}

TEST(CornerImpact, FindsTooLittleRestitution) {
  const World world = Tumbling(kOnCorner, 0);
  EXPECT_TRUE(Finds(
      Judge(world, Tumbled(world, ImpactRule::kNewton, 0.55), ClaimOf("corner_impact")),
      MeasureKind::kSpinError));
}

TEST(CornerImpact, RefusesFlatLandingsAndCornersWithFriction) {
  EXPECT_EQ(FaultsOf(Tumbling(kOnCorner, 0.3), ClaimOf("corner_impact")).size(), 1U);
  EXPECT_EQ(
      FaultsOf(Tumbling(Eigen::Quaterniond::Identity(), 0), ClaimOf("corner_impact"))
          .size(),
      1U);
  World world = Tumbling(kOnEdge, 0.3);
  world.bodies[0].v_WB.z() = 1;
  EXPECT_EQ(FaultsOf(world, ClaimOf("corner_impact")).size(), 1U);
  EXPECT_TRUE(FaultsOf(Tumbling(kOnEdge, 0.3), ClaimOf("corner_impact")).empty());
}

TEST(TurnsOnce, row_impact) {
  const World world = Cradle(0.02);
  EXPECT_TRUE(TurnsOnce(world, Struck(world, {}), ClaimOf("row_impact")));
}

TEST(TurnsOnce, sphere_impact_on_a_plane) {
  const World world = Oblique(0.8, 0.1, 50);
  EXPECT_TRUE(TurnsOnce(world, Struck(world, {}), ClaimOf("sphere_impact")));
}

TEST(TurnsOnce, sphere_impact) {
  const World world = TwoSpheres();
  EXPECT_TRUE(TurnsOnce(world, Struck(world, {}), ClaimOf("sphere_impact")));
}

TEST(TurnsOnce, corner_impact) {
  const World world = Tumbling(kOnEdge, 0.3);
  EXPECT_TRUE(
      TurnsOnce(world, Tumbled(world, ImpactRule::kNewton), ClaimOf("corner_impact")));
}

}  // namespace
}  // namespace touchstone
