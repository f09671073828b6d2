#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/truth/sliding.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Eigen::Vector2d Heading(double degrees) {
  return {std::cos(degrees * kDegree), std::sin(degrees * kDegree)};
}

/** Returns the friction impulse that an engine applies in place of `J`, which would stop
 the slip. */
Eigen::Vector2d Held(FrictionCone cone, Eigen::Vector2d J, double limit) {
  switch (cone) {
    case FrictionCone::kCircle:
      return J.norm() > limit ? Eigen::Vector2d(J.normalized() * limit) : J;
    case FrictionCone::kBox:
      return {std::clamp(J.x(), -limit, limit), std::clamp(J.y(), -limit, limit)};
    case FrictionCone::kDiamond:
      break;
  }
  // Along the edge |x| + |y| = limit, by bisection of how much both components shrink.
  double low = 0;
  double high = J.cwiseAbs().maxCoeff();
  const auto shrunk = [&](double by) {
    return Eigen::Vector2d((J.cwiseAbs().array() - by).max(0));
  };
  if (J.lpNorm<1>() <= limit) return J;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (shrunk(middle).sum() > limit ? low : high) = middle;
  }
  const Eigen::Vector2d left = shrunk(high);
  return {std::copysign(left.x(), J.x()), std::copysign(left.y(), J.y())};
}

/** Moreau's scheme for the one body of `world` on the plane y = 0: a box that only
 slides, or a sphere or roller whose contact is at `lever` times its radius. */
Trajectory Rubbed(const World& world, FrictionCone cone, double mu, double lever = 1) {
  const RigidBody& body = world.bodies[0];
  const auto* box = std::get_if<Box>(&body.placed.shape);
  const double height = box ? box->half_extents.y() : RadiusOf(body);
  const double r = box ? 0 : lever * height;
  // The rolling axis is the z axis of the body.
  const double inertia = InertiaOf(body).z();
  const double inverse_k = body.mass * r * r / inertia;
  return Stepped(world, [=, &world](WorldState& state) {
    BodyState& is = state.bodies[0];
    is.v_WB +=
        world.dt * (world.gravity_W + world.bodies[0].force_W / world.bodies[0].mass);
    if (is.p_WB.y() <= height && is.v_WB.y() < 0) {
      const double normal = -is.v_WB.y();
      is.v_WB.y() = 0;
      const Eigen::Vector3d arm(0, -r, 0);
      const Eigen::Vector3d u = is.v_WB + is.w_WB.cross(arm);
      const Eigen::Vector2d J =
          Held(cone, Eigen::Vector2d(-u.x(), -u.z()) / (1 + inverse_k), mu * normal);
      const Eigen::Vector3d J_W(J.x(), 0, J.y());
      is.v_WB += J_W;
      is.w_WB += world.bodies[0].mass * arm.cross(J_W) / inertia;
    }
    is.p_WB += world.dt * is.v_WB;
  });
}

World SlidingBlock(double heading, double dt = 1e-3) {
  World world;
  RigidBody block = BodyOf("block", Box{{0.25, 0.1, 0.25}}, 2, {0.4, 0.1, -0.3});
  block.v_WB = 5 * Eigen::Vector3d(Heading(heading).x(), 0, Heading(heading).y());
  block.restitution = 0;
  block.friction = 0.5;
  RigidBody ground = GroundOf();
  ground.friction = 0.5;
  world.bodies = {block, ground};
  world.gravity_W = {0, -9.81, 0};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(1.6 / dt));
  return world;
}

TEST(Sliding, StopsAtThePublishedPositions) {
  // Distance and heading of a block at 5 m/s with μ = ½ (headings of 15, 30, 45 degrees).
  struct Row {
    double heading, box, box_at, diamond, diamond_at;
  };
  for (const Row& row : {Row{15, 2.383829, 4.107, 2.849220, 26.565},
                         Row{30, 2.014703, 18.435, 3.371243, 40.893},
                         Row{45, 1.802005, 45, 3.604010, 45}}) {
    const auto stop = [&](FrictionCone cone) {
      return SlipAfter(cone, 5 * Heading(row.heading), 0.5 * 9.81, 10).travelled;
    };
    const Eigen::Vector2d circle = stop(FrictionCone::kCircle);
    EXPECT_NEAR(circle.norm(), 2.548420, 1e-6);
    const Eigen::Vector2d box = stop(FrictionCone::kBox);
    EXPECT_NEAR(box.norm(), row.box, 1e-6);
    EXPECT_NEAR(std::atan2(box.y(), box.x()) / kDegree, row.box_at, 1e-3);
    const Eigen::Vector2d diamond = stop(FrictionCone::kDiamond);
    EXPECT_NEAR(diamond.norm(), row.diamond, 1e-6);
    EXPECT_NEAR(std::atan2(diamond.y(), diamond.x()) / kDegree, row.diamond_at, 1e-3);
  }
}

TEST(Sliding, IsTheLimitOfSmallStepsForEveryCone) {
  const Eigen::Vector2d start(1.7, -3.1);
  for (const FrictionCone cone :
       {FrictionCone::kCircle, FrictionCone::kBox, FrictionCone::kDiamond}) {
    Eigen::Vector2d v = start;
    Eigen::Vector2d p = Eigen::Vector2d::Zero();
    const double h = 1e-5;
    for (int i = 1; i <= 100000; ++i) {
      v += Held(cone, -v, 4 * h);
      p += h * v;
      if (i % 20000 != 0) continue;
      const Slip truth = SlipAfter(cone, start, 4, i * h);
      EXPECT_LE((truth.velocity - v).norm(), 1e-4) << NameOf(cone) << i * h;
      EXPECT_LE((truth.travelled - p).norm(), 1e-4) << NameOf(cone) << i * h;
    }
  }
}

TEST(Sliding, ADrivenBodyIsTheLimitOfSmallStepsForEveryCone) {
  for (const FrictionCone cone :
       {FrictionCone::kCircle, FrictionCone::kBox, FrictionCone::kDiamond}) {
    for (const Eigen::Vector2d& drive :
         {Eigen::Vector2d(2, -7), Eigen::Vector2d(3, 3.5), Eigen::Vector2d(1, 2)}) {
      Eigen::Vector2d v = Eigen::Vector2d::Zero();
      const double h = 1e-4;
      for (int i = 0; i < 10000; ++i) {
        v += h * drive;
        v += Held(cone, -v, 4 * h);
      }
      EXPECT_LE((DrivenFromRest(cone, drive, 4) - v).norm(), 1e-3)
          << NameOf(cone) << drive.transpose();
    }
  }
}

TEST(SlideToStop, AMotionByCoulombsLawPasses) {
  for (const double dt : {1.0 / 60, 1.0 / 240, 1e-3}) {
    const World world = SlidingBlock(30, dt);
    EXPECT_TRUE(Passes(Judge(world, Rubbed(world, FrictionCone::kCircle, 0.5),
                             ClaimOf("slide_to_stop"))))
        << dt;
  }
}

TEST(SlideToStop, RecognisesTheOtherCones) {
  const World world = SlidingBlock(30);
  for (const FrictionCone cone : {FrictionCone::kBox, FrictionCone::kDiamond}) {
    const LawFinding finding =
        Of(Judge(world, Rubbed(world, cone, 0.5), ClaimOf("slide_to_stop")),
           MeasureKind::kPositionError);
    EXPECT_GT(finding.value, finding.tolerance.value);
    EXPECT_EQ(finding.recognised, NameOf(cone));
  }
}

TEST(SlideToStop, FindsAWrongCoefficient) {
  const World world = SlidingBlock(30);
  const std::vector<LawFinding> findings =
      Judge(world, Rubbed(world, FrictionCone::kCircle, 0.49), ClaimOf("slide_to_stop"));
  EXPECT_TRUE(Finds(findings, MeasureKind::kPositionError));
  EXPECT_TRUE(Finds(findings, MeasureKind::kFriction));
  // The coefficient of a cone is judged as sharply.
  EXPECT_TRUE(Finds(
      Judge(world, Rubbed(world, FrictionCone::kBox, 0.49), ClaimOf("slide_to_stop")),
      MeasureKind::kPositionError));
}

TEST(SlideToStop, FindsALightBodyThatSlidesForEver) {
  const World world = SlidingBlock(30);
  EXPECT_TRUE(Finds(
      Judge(world, Rubbed(world, FrictionCone::kCircle, 0), ClaimOf("slide_to_stop")),
      MeasureKind::kPositionError));
}

/** The motion with its first body rotating about `axis_W` at `spin` [rad/s]; the body's
 spin states it if `admits`. */
Trajectory Turning(Trajectory motion, const Eigen::Vector3d& axis_W, double spin,
                   bool admits) {
  for (std::size_t s = 1; s < motion.samples.size(); ++s) {
    BodyState& is = motion.samples[s].bodies[0];
    is.q_WB = Turned(is.q_WB, motion.times[s] * spin * axis_W);
    if (admits) is.w_WB += spin * axis_W;
  }
  return motion;
}

TEST(SlideToStop, FindsARotationWithoutACause) {
  const World world = SlidingBlock(30);
  const Trajectory right = Rubbed(world, FrictionCone::kCircle, 0.5);
  // 2 g h² (1 + μ) × 1.5 over 0.25 m are 1.8e-4 rad; the solver's 1e-5 of 5 m/s in 1.6 s
  // adds 3.2e-4.
  for (const Eigen::Vector3d& axis_W :
       {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0.6, 0, -0.8)}) {
    EXPECT_TRUE(
        Finds(Judge(world, Turning(right, axis_W, 4e-4, false), ClaimOf("slide_to_stop")),
              MeasureKind::kOrientationError));
    EXPECT_TRUE(Passes(
        Judge(world, Turning(right, axis_W, 2e-4, true), ClaimOf("slide_to_stop"))));
    EXPECT_TRUE(
        Finds(Judge(world, Turning(right, axis_W, 1, true), ClaimOf("slide_to_stop")),
              MeasureKind::kSpinError));
  }
}

TEST(SlideToStop, NamesTheWrongOneOfSeveralBodies) {
  World world = SlidingBlock(30);
  const Trajectory right = Rubbed(world, FrictionCone::kCircle, 0.5);
  const Trajectory wrong = Rubbed(world, FrictionCone::kCircle, 0.4);
  world.bodies.push_back(world.bodies[0]);
  world.bodies[2].name = "other";
  Trajectory both = right;
  for (std::size_t s = 0; s < both.samples.size(); ++s)
    both.samples[s].bodies.push_back(wrong.samples[s].bodies[0]);
  const std::vector<LawFinding> findings = Judge(world, both, ClaimOf("slide_to_stop"));
  EXPECT_TRUE(Finds(findings, MeasureKind::kPositionError));
  EXPECT_NE(Of(findings, MeasureKind::kPositionError).proof.find("other"),
            std::string::npos);
}

TEST(SlideToStop, RefusesSlopesSpheresAndTowers) {
  World world = SlidingBlock(30);
  EXPECT_TRUE(FaultsOf(world, ClaimOf("slide_to_stop", {"block"},
                                      {{"expected_distance", 2.548420},
                                       {"expected_time", 5 / 4.905}}))
                  .empty());
  world.bodies[0].placed = BodyOf("", Box{{0.25, 0.6, 0.25}}, 2, {0, 0.6, 0}).placed;
  EXPECT_EQ(FaultsOf(world, ClaimOf("slide_to_stop")).size(), 1U);
  world = SlidingBlock(30);
  world.gravity_W.x() = 0.1;
  EXPECT_EQ(FaultsOf(world, ClaimOf("slide_to_stop")).size(), 1U);
}

/** Gazebo's friction demo; gravity is tilted in place of the slope. */
World Slope(const Shape& shape, double height, double degrees, double mu,
            double towards = 0) {
  World world;
  RigidBody body = BodyOf("body", shape, 1.5, {0.2, height, 0.1});
  body.restitution = 0;
  body.friction = mu;
  RigidBody ground = GroundOf();
  ground.friction = mu;
  world.bodies = {body, ground};
  const double along = 9.81 * std::sin(degrees * kDegree);
  world.gravity_W = {along * std::cos(towards * kDegree),
                     -9.81 * std::cos(degrees * kDegree),
                     along * std::sin(towards * kDegree)};
  world.dt = 1e-3;
  world.steps = 2000;
  return world;
}

const Shape kBlock = Box{{0.5, 0.05, 0.5}};
const Shape kBall = Sphere{0.5};

TEST(Incline, ABlockSticksAndSlidesAtTheThreshold) {
  for (const double mu : {0.998, 0.9995, 1.0, 1.01}) {
    const World world = Slope(kBlock, 0.05, 45, mu);
    const Trajectory motion = Rubbed(world, FrictionCone::kCircle, mu);
    EXPECT_TRUE(Passes(Judge(world, motion, ClaimOf("incline")))) << mu;
    EXPECT_NEAR(motion.samples.back().bodies[0].v_WB.x(),
                std::max(0.0, (1 - mu) * 9.81 * std::sqrt(0.5) * 2), 1e-9);
  }
}

TEST(Incline, FindsFrictionOffByAThousandth) {
  const World world = Slope(kBlock, 0.05, 45, 0.999);
  for (const double mu : {0.998, 1.0}) {
    EXPECT_TRUE(
        Finds(Judge(world, Rubbed(world, FrictionCone::kCircle, mu), ClaimOf("incline")),
              MeasureKind::kVelocityError));
  }
}

TEST(Incline, FindsARotationWithoutACause) {
  for (const double mu : {0.9, 1.01}) {  // It slides, and it stays.
    const World world = Slope(kBlock, 0.05, 45, mu);
    const Trajectory right = Rubbed(world, FrictionCone::kCircle, mu);
    const Trajectory turning = Turning(right, {0, 1, 0}, 1e-3, false);
    EXPECT_TRUE(
        Finds(Judge(world, turning, ClaimOf("incline")), MeasureKind::kOrientationError));
  }
}

TEST(Incline, RefusesABlockThatTips) {
  // It would tip about its edge 0.5 m ahead if its centre were more than 0.5 m up.
  EXPECT_TRUE(
      FaultsOf(Slope(Box{{0.5, 0.49, 0.5}}, 0.49, 45, 1.01), ClaimOf("incline")).empty());
  EXPECT_EQ(
      FaultsOf(Slope(Box{{0.5, 0.51, 0.5}}, 0.51, 45, 1.01), ClaimOf("incline")).size(),
      1U);
}

TEST(Incline, ASphereRollsOrSlips) {
  for (const double mu : {0.1, 0.16, 0.17, 1.0}) {
    const World world = Slope(kBall, 0.5, 30, mu);
    EXPECT_TRUE(Passes(
        Judge(world, Rubbed(world, FrictionCone::kCircle, mu), ClaimOf("incline"))))
        << mu;
  }
  // Drake's inclined plane: (5/7) g sin 15°.
  EXPECT_TRUE(FaultsOf(Slope(kBall, 0.5, 15, 0.5),
                       ClaimOf("incline", {}, {{"expected_acceleration", 1.813582}}))
                  .empty());
}

TEST(Incline, FindsASphereWithTheInertiaOfAShell) {
  const World world = Slope(kBall, 0.5, 30, 1);
  World shell = world;
  shell.bodies[0].inertia = Eigen::Vector3d::Constant(2.0 / 3 * 1.5 * 0.25);
  const std::vector<LawFinding> findings =
      Judge(world, Rubbed(shell, FrictionCone::kCircle, 1), ClaimOf("incline"));
  EXPECT_TRUE(Finds(findings, MeasureKind::kVelocityError));
  EXPECT_TRUE(Finds(findings, MeasureKind::kSpinError));
}

TEST(Incline, RecognisesTheOtherConesBetweenTheirAxes) {
  for (const FrictionCone cone : {FrictionCone::kBox, FrictionCone::kDiamond}) {
    const World world = Slope(kBlock, 0.05, 45, 0.9, 25);
    EXPECT_EQ(Of(Judge(world, Rubbed(world, cone, 0.9), ClaimOf("incline")),
                 MeasureKind::kVelocityError)
                  .recognised,
              NameOf(cone));
  }
}

TEST(Incline, FindsTooMuchFrictionEvenIfTheBoxConeHoldsToo) {
  // tan 45° = 1 along 40°: the box cone of 0.9 holds both components.
  const World world = Slope(kBlock, 0.05, 45, 0.9, 40);
  for (const double mu : {1.1, 1.3}) {
    EXPECT_TRUE(
        Finds(Judge(world, Rubbed(world, FrictionCone::kCircle, mu), ClaimOf("incline")),
              MeasureKind::kVelocityError))
        << mu;
  }
}

World BowlingBall(double dt = 1e-3) {
  // Drake's bowling ball, on the plane y = 0.
  World world;
  RigidBody ball = BodyOf("ball", Sphere{0.10795}, 6.35, {0, 0.10795, 0});
  ball.inertia = Eigen::Vector3d::Constant(0.0296);
  ball.v_WB = {0, 0, 8};
  ball.w_WB = {0, 0, -8 * std::numbers::pi};
  ball.restitution = 0;
  ball.friction = 0.12;
  RigidBody ground = GroundOf();
  ground.friction = 0.12;
  world.bodies = {ball, ground};
  world.gravity_W = {0, -9.8, 0};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(3 / dt));
  return world;
}

TEST(SlipToRoll, AMotionByCoulombsLawPasses) {
  for (const double dt : {1.0 / 60, 1.0 / 240, 1e-3}) {
    const World world = BowlingBall(dt);
    EXPECT_TRUE(Passes(Judge(world, Rubbed(world, FrictionCone::kCircle, 0.12),
                             ClaimOf("slip_to_roll"))))
        << dt;
  }
}

TEST(SlipToRoll, KnowsTheBowlingBall) {
  EXPECT_TRUE(FaultsOf(BowlingBall(), ClaimOf("slip_to_roll", {},
                                              {{"expected_rolling_time", 2.052407348},
                                               {"expected_rolling_speed",
                                                std::hypot(0.77518174, 5.71423797)}}))
                  .empty());
  World world = BowlingBall();
  const Trajectory motion = Rubbed(world, FrictionCone::kCircle, 0.12);
  EXPECT_LE((motion.samples[2052].bodies[0].p_WB -
             Eigen::Vector3d(0.79549435, 0.10795, 14.07360139))
                .norm(),
            5e-3);
}

TEST(SlipToRoll, FindsFrictionThatUsesTheSlipOfTheCentreAlone) {
  // ω × r is omitted: the ball never begins to roll.
  const World world = BowlingBall();
  const std::vector<LawFinding> findings = Judge(
      world, Rubbed(world, FrictionCone::kCircle, 0.12, 0), ClaimOf("slip_to_roll"));
  EXPECT_TRUE(Finds(findings, MeasureKind::kSpinError));
  EXPECT_TRUE(Finds(findings, MeasureKind::kVelocityError));
}

TEST(SlipToRoll, FindsALeverThatIsTooShort) {
  const World world = BowlingBall();
  EXPECT_TRUE(Finds(Judge(world, Rubbed(world, FrictionCone::kCircle, 0.12, 0.99),
                          ClaimOf("slip_to_roll")),
                    MeasureKind::kVelocityError));
}

TEST(OnPlanes, ABodyThatFliesOffIsNotExcusedByItsNormalSpeed) {
  const auto thrown = [](const World& world, FrictionCone cone, double mu) {
    Trajectory trajectory = Rubbed(world, cone, mu);
    for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
      BodyState& ball = trajectory.samples[s].bodies[0];
      ball.v_WB += 2 * world.bodies[1].placed.X_WB.R_WB.col(2);
      ball.v_WB.x() += 0.5;
    }
    return trajectory;
  };
  const World bowling = BowlingBall();
  EXPECT_TRUE(Finds(Judge(bowling, thrown(bowling, FrictionCone::kCircle, 0.12),
                          ClaimOf("slip_to_roll")),
                    MeasureKind::kVelocityError));
  const World slope = Slope(kBall, 0.5, 15, 0.5);
  EXPECT_TRUE(
      Finds(Judge(slope, thrown(slope, FrictionCone::kCircle, 0.5), ClaimOf("incline")),
            MeasureKind::kVelocityError));
}

TEST(SlipToRoll, RecognisesTheOtherCones) {
  for (const FrictionCone cone : {FrictionCone::kBox, FrictionCone::kDiamond}) {
    const World world = BowlingBall();
    EXPECT_EQ(Of(Judge(world, Rubbed(world, cone, 0.12), ClaimOf("slip_to_roll")),
                 MeasureKind::kPositionError)
                  .recognised,
              NameOf(cone));
  }
}

/** A ball that starts rolling up and across the slope of `degrees`, with a spin about the
 normal. */
World RollingUp(double degrees) {
  World world = Slope(kBall, 0.5, degrees, 0.6, 20);
  RigidBody& ball = world.bodies[0];
  ball.v_WB = {-2, 0, 1.5};
  ball.w_WB = Eigen::Vector3d(0, 4, 0) + Eigen::Vector3d::UnitY().cross(ball.v_WB) / 0.5;
  return world;
}

TEST(Rolls, OnALevelPlaneAndUpASlope) {
  for (const double degrees : {0.0, 15.0}) {
    const World world = RollingUp(degrees);
    EXPECT_TRUE(
        Passes(Judge(world, Rubbed(world, FrictionCone::kCircle, 0.6), ClaimOf("rolls"))))
        << degrees;
  }
  EXPECT_TRUE(FaultsOf(RollingUp(15),
                       ClaimOf("rolls", {"body"}, {{"expected_acceleration", 1.813582}}))
                  .empty());
}

TEST(Rolls, FindsALeverThatIsTooShortAndRollingResistance) {
  const World world = RollingUp(15);
  EXPECT_TRUE(Finds(
      Judge(world, Rubbed(world, FrictionCone::kCircle, 0.6, 0.99), ClaimOf("rolls")),
      MeasureKind::kSpinError));
  Trajectory slowed = Rubbed(world, FrictionCone::kCircle, 0.6);
  for (std::size_t s = 0; s < slowed.samples.size(); ++s)
    slowed.samples[s].bodies[0].v_WB *= std::exp(-1e-3 * slowed.times[s]);
  EXPECT_TRUE(Finds(Judge(world, slowed, ClaimOf("rolls")), MeasureKind::kVelocityError));
}

TEST(Rolls, RefusesSlipAndTooLittleFriction) {
  World world = RollingUp(15);
  world.bodies[0].w_WB.x() += 0.1;
  EXPECT_EQ(FaultsOf(world, ClaimOf("rolls")).size(), 1U);
  world = RollingUp(15);
  world.bodies[0].friction = 0.001;
  EXPECT_EQ(FaultsOf(world, ClaimOf("rolls")).size(), 1U);
}

/** A roller that starts up a slope of 15°. Its axis is the world's z axis. */
World RollerUp(const Shape& shape) {
  World world = Slope(shape, 0.5, 15, 0.6);
  world.bodies[0].v_WB = {-2, 0, 0};
  world.bodies[0].w_WB = {0, 0, 4};
  return world;
}

TEST(Rolls, OnTheSideOfACylinderOrACapsule) {
  for (const Shape& shape : {Shape(Cylinder{0.5, 0.7}), Shape(Capsule{0.5, 0.7})}) {
    const World world = RollerUp(shape);
    EXPECT_TRUE(Passes(
        Judge(world, Rubbed(world, FrictionCone::kCircle, 0.6), ClaimOf("rolls"))));
  }
  // g sin 15°/(1 + 1/2); in a capsule 3·0.7/(3·0.7 + 2·0.5) = 21/31 of the mass is tube.
  EXPECT_TRUE(FaultsOf(RollerUp(Cylinder{0.5, 0.7}),
                       ClaimOf("rolls", {"body"}, {{"expected_acceleration", 1.692677}}))
                  .empty());
  EXPECT_TRUE(FaultsOf(RollerUp(Capsule{0.5, 0.7}),
                       ClaimOf("rolls", {"body"}, {{"expected_acceleration", 1.729878}}))
                  .empty());
}

TEST(Rolls, FindsARollerWithTheInertiaOfABall) {
  const World world = RollerUp(Cylinder{0.5, 0.7});
  World wrong = world;
  wrong.bodies[0].inertia = Eigen::Vector3d(0.2, 0.2, 0.4 * 1.5 * 0.25);
  const Trajectory motion = Rubbed(wrong, FrictionCone::kCircle, 0.6);
  EXPECT_TRUE(Finds(Judge(world, motion, ClaimOf("rolls")), MeasureKind::kVelocityError));
}

TEST(Rolls, RefusesARollerThatStandsMovesAlongItsAxisOrSpinsAboutAnother) {
  const auto refuses = [](const World& world) {
    return FaultsOf(world, ClaimOf("rolls")).size() == 1U;
  };
  World world = RollerUp(Cylinder{0.5, 0.7});
  const auto turn = [&](const Eigen::Vector3d& angle_W) {
    world.bodies[0].placed.X_WB =
        Pose::FromQuaternion(world.bodies[0].placed.X_WB.p_WB,
                             Turned(Eigen::Quaterniond::Identity(), angle_W));
  };
  turn({kDegree * 90, 0, 0});
  world.bodies[0].placed.X_WB.p_WB.y() = 0.7;
  EXPECT_TRUE(refuses(world));
  world.bodies[0].placed.X_WB.p_WB.y() = 0.5;
  turn({0, kDegree * 1, 0});
  EXPECT_TRUE(refuses(world));
  world = RollerUp(Cylinder{0.5, 0.7});
  world.bodies[0].w_WB.y() = 1e-3;
  EXPECT_TRUE(refuses(world));
  world = RollerUp(Cylinder{0.5, 0.7});
  world.bodies[0].inertia = Eigen::Vector3d(0.2, 0.3, 0.15);
  EXPECT_TRUE(refuses(world));
}

/** A puck that spins about y on the ground; √2 μ g m R/I = 2 √2 μ g/r = 27.7 rad/s². */
World SpinningPuck(double mu = 0.5) {
  World world;
  RigidBody puck = BodyOf("puck", Cylinder{0.5, 0.1}, 2, {0.4, 0.1, -0.3});
  puck.placed.X_WB = Pose::FromQuaternion(
      {0.4, 0.1, -0.3},
      Turned(Eigen::Quaterniond::Identity(), {-std::numbers::pi / 2, 0, 0}));
  puck.w_WB = {0, 30, 0};
  puck.restitution = 0;
  puck.friction = mu;
  RigidBody ground = GroundOf();
  ground.friction = mu;
  world.bodies = {puck, ground};
  world.gravity_W = {0, -9.81, 0};
  world.dt = 1e-3;
  world.steps = 1500;
  return world;
}

/** The motion of the puck if its spin falls by `brake` [rad/s²] to `end` [rad/s]. */
Trajectory Braked(const World& world, double brake, double end = 0) {
  return Sampled(world, [=, &world](double t) {
    WorldState state;
    for (const RigidBody& body : world.bodies)
      state.bodies.push_back({body.placed.X_WB.p_WB,
                              Eigen::Quaterniond(body.placed.X_WB.R_WB), body.v_WB,
                              body.w_WB});
    state.bodies[0].w_WB.y() = std::max(end, 30 - brake * t);
    return state;
  });
}

/** The motion of the body if it leans by `angle` at once and stays so, with `share` of
 its spin. */
Trajectory Leaning(const World& world, double angle, double share) {
  Trajectory motion = Braked(world, 0);
  for (std::size_t s = 1; s < motion.samples.size(); ++s) {
    BodyState& is = motion.samples[s].bodies[0];
    is.q_WB = Turned(is.q_WB, {angle, 0, 0});
    is.w_WB *= share;
  }
  return motion;
}

// Its moment about the normal grows by I_x/I_z − 1 = 66 times the square of the angle.
TEST(SpinsOnPlane, ABodyThatLeansByItsSlopKeepsItsAngularMomentum) {
  World world = SpinningPuck(0);
  world.bodies[0].placed.shape = Cylinder{0.1, 1};
  world.bodies[0].placed.X_WB.p_WB.y() = 1;
  OracleInfo info = DoubleEngine();
  info.slop = 0.005;
  info.slop_documented_by = "section 4";
  const double angle = info.slop / 0.2;
  const double share = 1 / (1 + (66 + 1.0 / 6) * std::pow(std::sin(angle), 2));
  const auto judged = [&](double spin) {
    return Judge(world, Leaning(world, angle, spin), ClaimOf("spins_on_plane"), info);
  };
  EXPECT_TRUE(Passes(judged(share)));
  // So does an engine without a gyroscopic term, which keeps the spin.
  EXPECT_TRUE(Passes(judged(1)));
  EXPECT_TRUE(Finds(judged(1.05), MeasureKind::kSpinError));
  EXPECT_TRUE(Finds(judged(share * share), MeasureKind::kSpinError));
}

// The lean moves the rim out by 3 m · 0.02 m / 0.5 m, a quarter of its radius.
TEST(SpinsOnPlane, GrantsTheReachOfABodyThatLeansByItsSlop) {
  World world = SpinningPuck();
  world.bodies[0].placed.shape = Cylinder{0.5, 3};
  world.bodies[0].placed.X_WB.p_WB.y() = 3;
  const auto judged = [&](double brake, double slop) {
    OracleInfo info = DoubleEngine();
    info.slop = slop;
    info.slop_documented_by = "section 4";
    return Judge(world, Braked(world, brake), ClaimOf("spins_on_plane"), info);
  };
  EXPECT_TRUE(Passes(judged(27.7, 0)));
  EXPECT_TRUE(Finds(judged(34, 0), MeasureKind::kSpinError));
  EXPECT_TRUE(Passes(judged(34, 0.02)));
  EXPECT_TRUE(Finds(judged(45, 0.02), MeasureKind::kSpinError));
}

TEST(SpinsOnPlane, AllowsEveryTorqueUpToThatOfTheRim) {
  const World world = SpinningPuck();
  for (const double brake : {0.0, 13.08, 19.62, 27.7}) {
    EXPECT_TRUE(Passes(Judge(world, Braked(world, brake), ClaimOf("spins_on_plane"))))
        << brake;
  }
}

TEST(SpinsOnPlane, FindsASpinThatGrowsReversesOrFallsTooFast) {
  const World world = SpinningPuck();
  for (const auto& [brake, end] :
       {std::pair(-1e-2, 0.0), std::pair(25.0, -0.1), std::pair(28.1, 0.0)}) {
    EXPECT_TRUE(Finds(Judge(world, Braked(world, brake, end), ClaimOf("spins_on_plane")),
                      MeasureKind::kSpinError))
        << brake;
  }
}

TEST(SpinsOnPlane, FindsAnyBrakeWithoutFriction) {
  const World world = SpinningPuck(0);
  EXPECT_TRUE(Passes(Judge(world, Braked(world, 0), ClaimOf("spins_on_plane"))));
  EXPECT_TRUE(Finds(Judge(world, Braked(world, 1e-3), ClaimOf("spins_on_plane")),
                    MeasureKind::kSpinError));
}

TEST(SpinsOnPlane, RefusesBallsSlopesMotionAndOtherAxes) {
  const auto refuses = [](const World& world) {
    return FaultsOf(world, ClaimOf("spins_on_plane")).size() == 1U;
  };
  World world = SpinningPuck();
  EXPECT_TRUE(FaultsOf(world, ClaimOf("spins_on_plane", {"puck"})).empty());
  world.bodies[0].v_WB.x() = 0.1;
  EXPECT_TRUE(refuses(world));
  world = SpinningPuck();
  world.bodies[0].w_WB.x() = 0.1;
  EXPECT_TRUE(refuses(world));
  world = SpinningPuck();
  world.gravity_W.x() = 0.1;
  EXPECT_TRUE(refuses(world));
  world = SpinningPuck();
  world.bodies[0].placed = BodyOf("", kBall, 2, {0, 0.5, 0}).placed;
  EXPECT_TRUE(refuses(world));
  world.bodies[0].placed = BodyOf("", Cylinder{0.5, 0.1}, 2, {0, 0.5, 0}).placed;
  EXPECT_TRUE(refuses(world));
}

/** SimBenchmark's rolling scene, with a force at 60° to the x axis. */
World PulledBox(double degrees) {
  World world;
  RigidBody box = BodyOf("box", Box{{10, 0.5, 10}}, 10, {0, 0.5 - 2e-5, 0});
  box.friction = 0.4;
  box.force_W = 150 * Eigen::Vector3d(Heading(degrees).x(), 0, Heading(degrees).y());
  RigidBody ground = GroundOf();
  ground.friction = 0.4;
  world.bodies = {box, ground};
  for (int i = 0; i < 25; ++i) {
    const int row = i / 5;
    RigidBody ball = BodyOf("ball" + std::to_string(i), Sphere{0.5}, 1,
                            {2.0 * (i % 5) - 4, 1.5 - 6e-5, 2.0 * row - 4});
    ball.friction = 1.6;  // √(0.4 · 1.6) = 0.8
    world.bodies.push_back(ball);
  }
  world.gravity_W = {0, -9.81, 0};
  world.dt = 1e-3;
  world.steps = 400;
  return world;
}

const Claim kPulled =
    ClaimOf("rolling_box", {}, {{"expected_box_acceleration", 12.66 / (10 + 50.0 / 7)}});

/** Solves the friction impulses of all contacts by Gauss-Seidel; `mu` is the ground's. */
Trajectory Pulled(const World& world, FrictionCone cone, double mu, int iterations) {
  return Stepped(world, [=, &world](WorldState& state) {
    const double h = world.dt;
    Eigen::Vector2d ground = Eigen::Vector2d::Zero();
    std::vector<Eigen::Vector2d> grip(25, Eigen::Vector2d::Zero());
    BodyState& box = state.bodies[0];
    box.v_WB += h / 10 * world.bodies[0].force_W;
    const auto flat = [](const Eigen::Vector3d& v) {
      return Eigen::Vector2d(v.x(), v.z());
    };
    const auto lift = [](const Eigen::Vector2d& v) {
      return Eigen::Vector3d(v.x(), 0, v.y());
    };
    for (int iteration = 0; iteration < iterations; ++iteration) {
      for (std::size_t i = 0; i < 25; ++i) {
        BodyState& ball = state.bodies[i + 2];
        const Eigen::Vector3d arm(0, -0.5, 0);
        const Eigen::Vector2d u = flat(ball.v_WB + ball.w_WB.cross(arm) - box.v_WB);
        const Eigen::Vector2d J =
            Held(FrictionCone::kCircle, grip[i] - u / (3.5 + 0.1), 0.8 * 9.81 * h);
        const Eigen::Vector3d J_W = lift(J - grip[i]);
        grip[i] = J;
        ball.v_WB += J_W;
        ball.w_WB += arm.cross(J_W) / 0.1;
        box.v_WB -= J_W / 10;
      }
      const Eigen::Vector2d J =
          Held(cone, ground - 10 * flat(box.v_WB), mu * 35 * 9.81 * h);
      box.v_WB += lift(J - ground) / 10;
      ground = J;
    }
    for (BodyState& body : state.bodies) body.p_WB += h * body.v_WB;
  });
}

TEST(RollingBox, ASolvedMotionPasses) {
  const World world = PulledBox(60);
  EXPECT_TRUE(
      Passes(Judge(world, Pulled(world, FrictionCone::kCircle, 0.4, 200), kPulled)));
}

TEST(RollingBox, ABoxThatIsHeldShowsNoCone) {
  // The box cone holds it; so does a rougher floor.
  const World world = PulledBox(60);
  const Trajectory held = Pulled(world, FrictionCone::kBox, 0.4, 200);
  EXPECT_LE(held.samples.back().bodies[0].v_WB.norm(), 1e-9);
  EXPECT_TRUE(Finds(Judge(world, held, kPulled), MeasureKind::kVelocityError));
}

TEST(RollingBox, FindsASolverThatStopsTooSoonAndAWrongCoefficient) {
  const World world = PulledBox(60);
  EXPECT_TRUE(Finds(Judge(world, Pulled(world, FrictionCone::kCircle, 0.4, 3), kPulled),
                    MeasureKind::kVelocityError));
  EXPECT_TRUE(
      Finds(Judge(world, Pulled(world, FrictionCone::kCircle, 0.401, 200), kPulled),
            MeasureKind::kVelocityError));
}

TEST(RollingBox, KnowsItsNumbersAndItsBalls) {
  const World world = PulledBox(60);
  EXPECT_TRUE(FaultsOf(world, ClaimOf("rolling_box", {"box", "ball0"})).empty());
  EXPECT_TRUE(FaultsOf(world, ClaimOf("rolling_box", {},
                                      {{"expected_box_acceleration", 0.7385},
                                       {"expected_ball_acceleration", 0.211},
                                       {"expected_ball_spin_rate", 1.055}}))
                  .empty());
  EXPECT_EQ(FaultsOf(world, ClaimOf("rolling_box", {"ball0", "box"})).size(), 1U);
  EXPECT_EQ(FaultsOf(world, ClaimOf("rolling_box", {},
                                    {{"expected_ball_acceleration", 0.2111},
                                     {"expected_ball_spin_rate", 0.527}}))
                .size(),
            2U);
}

TEST(TurnsOnce, slide_to_stop) {
  const World world = SlidingBlock(30);
  EXPECT_TRUE(TurnsOnce(world, Rubbed(world, FrictionCone::kCircle, 0.5),
                        ClaimOf("slide_to_stop")));
}

TEST(TurnsOnce, incline) {
  const World block = Slope(kBlock, 0.05, 45, 0.5);
  EXPECT_TRUE(
      TurnsOnce(block, Rubbed(block, FrictionCone::kCircle, 0.5), ClaimOf("incline")));
  const World ball = Slope(kBall, 0.5, 30, 1);
  EXPECT_TRUE(
      TurnsOnce(ball, Rubbed(ball, FrictionCone::kCircle, 1), ClaimOf("incline")));
}

TEST(TurnsOnce, slip_to_roll) {
  const World world = BowlingBall();
  EXPECT_TRUE(TurnsOnce(world, Rubbed(world, FrictionCone::kCircle, 0.12),
                        ClaimOf("slip_to_roll")));
}

TEST(TurnsOnce, rolls) {
  const World world = RollingUp(15);
  EXPECT_TRUE(
      TurnsOnce(world, Rubbed(world, FrictionCone::kCircle, 0.6), ClaimOf("rolls")));
}

TEST(TurnsOnce, spins_on_plane) {
  const World world = SpinningPuck();
  EXPECT_TRUE(TurnsOnce(world, Braked(world, 10), ClaimOf("spins_on_plane")));
}

TEST(TurnsOnce, rolling_box) {
  const World world = PulledBox(60);
  EXPECT_TRUE(TurnsOnce(world, Pulled(world, FrictionCone::kCircle, 0.4, 200), kPulled));
}

}  // namespace
}  // namespace touchstone
