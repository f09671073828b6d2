#include <array>
#include <cmath>
#include <functional>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

const Eigen::Vector3d kUp = Eigen::Vector3d(0.1, 1, -0.2).normalized();
const Eigen::Vector3d kHalfExtents{0.3, 0.1, 0.2};

/** A box whose lowest corner is `height` above a slope, turned askew about an axis in the
 slope by `angle`. */
World Tilted(double angle, double height = 0) {
  World world;
  const Eigen::Vector3d along = Eigen::Vector3d(1, 0.3, 2.1).cross(kUp).normalized();
  RigidBody box = BodyOf("box", Box{kHalfExtents}, 2, {0, 0, 0});
  const Eigen::Quaterniond q =
      Eigen::AngleAxisd(angle, along) *
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), kUp);
  box.placed.X_WB = Pose::FromQuaternion({0, 0, 0}, q.normalized());
  const double lowest =
      -(box.placed.X_WB.R_WB.transpose() * kUp).cwiseAbs().dot(kHalfExtents);
  box.placed.X_WB.p_WB = (height - lowest) * kUp;
  world.bodies = {box, GroundOf(kUp)};
  world.gravity_W = {0, 0, 0};
  world.dt = 1e-3;
  world.steps = 40;
  return world;
}

/** Returns the contacts of the lower four corners of a box with the slope. `share`: 0 for
 points on the slope, 1 for points on the box. */
std::vector<ContactImpulse> Corners(const World& world, double share) {
  std::vector<ContactImpulse> contacts;
  const Pose& X_WB = world.bodies[0].placed.X_WB;
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      const Eigen::Vector3d corner_W =
          X_WB.p_WB + X_WB.R_WB * kHalfExtents.cwiseProduct(Eigen::Vector3d(x, -1, z));
      const double separation = corner_W.dot(kUp);
      contacts.push_back({0, 1, 0, corner_W - (1 - share) * separation * kUp, kUp,
                          1e-3 * kUp, separation});
    }
  }
  return contacts;
}

/** Returns the motion at rest with these contacts in each step. */
Trajectory Resting(const World& world, const std::vector<ContactImpulse>& contacts) {
  Trajectory trajectory = Stepped(world, [](WorldState&) {});
  trajectory.gives_impulses = true;
  for (int step = 1; step <= world.steps; ++step) {
    for (ContactImpulse contact : contacts) {
      contact.step = step;
      trajectory.impulses.push_back(contact);
    }
  }
  return trajectory;
}

testing::AssertionResult PassWith(const World& world,
                                  const std::vector<ContactImpulse>& contacts) {
  return Passes(Judge(world, Resting(world, contacts), ClaimOf("contacts_on_bodies")));
}

testing::AssertionResult AreFoundWith(const World& world,
                                      const std::vector<ContactImpulse>& contacts) {
  return Finds(Judge(world, Resting(world, contacts), ClaimOf("contacts_on_bodies")),
               MeasureKind::kContactPlace);
}

TEST(ContactsOnBodies, PointsOnEitherBodyAndBetweenThemPass) {
  for (const double height : {-0.004, 0.0, 0.003}) {
    for (const double share : {0.0, 0.5, 1.0}) {
      EXPECT_TRUE(PassWith(Tilted(0.004, height), Corners(Tilted(0.004, height), share)))
          << height << " " << share;
    }
  }
}

TEST(ContactsOnBodies, TheSeparationOfAnotherCornerIsFound) {
  const World world = Tilted(0.004);
  std::vector<ContactImpulse> contacts = Corners(world, 0.5);
  double deepest = 1;
  for (const ContactImpulse& contact : contacts)
    deepest = std::min(deepest, contact.separation);
  for (ContactImpulse& contact : contacts) contact.separation = deepest;
  EXPECT_TRUE(AreFoundWith(world, contacts));
}

TEST(ContactsOnBodies, FindsWhatIsWrongWithOneContact) {
  const World world = Tilted(0.004, -0.002);
  const auto changed = [&](const std::function<void(ContactImpulse&)>& change) {
    std::vector<ContactImpulse> contacts = Corners(world, 0.5);
    change(contacts[2]);
    return contacts;
  };
  EXPECT_TRUE(AreFoundWith(world, changed([](ContactImpulse& c) { c.n_AB_W *= -1; })));
  EXPECT_TRUE(
      AreFoundWith(world, changed([](ContactImpulse& c) { std::swap(c.A, c.B); })));
  EXPECT_TRUE(AreFoundWith(world, changed([](ContactImpulse& c) { c.n_AB_W *= 1.01; })));
  EXPECT_TRUE(AreFoundWith(world, changed([](ContactImpulse& c) { c.n_AB_W *= 0; })));
  EXPECT_TRUE(
      AreFoundWith(world, changed([](ContactImpulse& c) { c.separation = NAN; })));
  EXPECT_TRUE(
      AreFoundWith(world, changed([](ContactImpulse& c) { c.p_WC += 0.01 * kUp; })));
  EXPECT_TRUE(AreFoundWith(world, changed([](ContactImpulse& c) {
                             c.p_WC += 0.7 * kUp.cross(Eigen::Vector3d::UnitX());
                           })));
}

TEST(ContactsOnBodies, FindsASeparationThatIsTooLargeAtACorner) {
  // The line through a corner meets the side of the box higher up, which is no contact.
  const World world = Tilted(0.004, -0.006);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    std::vector<ContactImpulse> contacts = Corners(world, 0.5);
    contacts[corner].separation += 1e-3;
    const LawFinding finding =
        Of(Judge(world, Resting(world, contacts), ClaimOf("contacts_on_bodies")),
           MeasureKind::kContactPlace);
    EXPECT_GT(finding.value, finding.tolerance.value) << corner;
    EXPECT_NEAR(finding.value, 1e-3, 1e-5) << corner;
  }
}

TEST(ContactsOnBodies, FindsAWrongNormalOfAPlaneAtAnySeparation) {
  for (const double height : {-0.002, 0.0, 0.001}) {
    const World world = Tilted(0.004, height);
    for (const double angle : {1e-6, 1e-3, 1.0}) {
      std::vector<ContactImpulse> contacts = Corners(world, 0.5);
      contacts[2].n_AB_W =
          Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()) * kUp;
      EXPECT_TRUE(AreFoundWith(world, contacts)) << height << " " << angle;
    }
  }
}

TEST(ContactsOnBodies, MeasuresHowFarSurfacesWouldHaveToBe) {
  // A separation that is off by d is right for a box that is off by d on static ground.
  const World world = Tilted(0);
  std::vector<ContactImpulse> contacts = Corners(world, 0.5);
  contacts[0].separation = -1e-3;
  const LawFinding finding =
      Of(Judge(world, Resting(world, contacts), ClaimOf("contacts_on_bodies")),
         MeasureKind::kContactPlace);
  EXPECT_NEAR(finding.value, 1e-3, 1e-8);
}

TEST(ContactsOnBodies, MeasuresAPointInsideStaticGroundThatShouldBeAboveIt) {
  // The box cannot move it out of the ground, so it is as far off as it is inside.
  const World world = Tilted(0, 0.001);
  std::vector<ContactImpulse> contacts = Corners(world, 0);
  contacts[0].p_WC -= 2e-3 * kUp;
  const LawFinding finding =
      Of(Judge(world, Resting(world, contacts), ClaimOf("contacts_on_bodies")),
         MeasureKind::kContactPlace);
  EXPECT_NEAR(finding.value, 2e-3, 1e-8);
}

TEST(ContactsOnBodies, KnowsSpheres) {
  World world;
  world.bodies = {BodyOf("left", Sphere{0.3}, 1, {0.1, 0.2, 0.3}),
                  BodyOf("right", Sphere{0.2}, 2, {0.1, 0.2, 0.3})};
  const Eigen::Vector3d n_W = Eigen::Vector3d(2, -1, 3).normalized();
  world.bodies[1].placed.X_WB.p_WB += 0.49 * n_W;
  world.gravity_W = {0, 0, 0};
  world.steps = 4;
  const Eigen::Vector3d p_W = world.bodies[0].placed.X_WB.p_WB + 0.295 * n_W;
  EXPECT_TRUE(PassWith(world, {{0, 0, 1, p_W, n_W, n_W, -0.01}}));
  EXPECT_TRUE(PassWith(world, {{0, 1, 0, p_W, -n_W, n_W, -0.01}}));
  EXPECT_TRUE(AreFoundWith(world, {{0, 0, 1, p_W, n_W, n_W, -0.011}}));
  EXPECT_TRUE(AreFoundWith(world, {{0, 0, 1, p_W, n_W, n_W, 0.01}}));
  EXPECT_TRUE(AreFoundWith(world, {{0, 0, 1, p_W + 0.02 * n_W, n_W, n_W, -0.01}}));
}

TEST(ContactsOnBodies, FindsAWrongNormalOfASphereAtAnySeparation) {
  for (const double s : {-0.01, 0.0, 0.01}) {
    for (const Shape& left : {Shape{Sphere{0.3}}, Shape{Box{{0.3, 0.2, 0.1}}}}) {
      World world;
      world.bodies = {BodyOf("left", left, 1, {0.1, 0.2, 0.3}),
                      BodyOf("ball", Sphere{0.2}, 2, {0.1, 0.2, 0.3})};
      Pose& X_WA = world.bodies[0].placed.X_WB;
      X_WA = Pose::FromQuaternion(X_WA.p_WB, Turned({1, 0, 0, 0}, {0.3, -0.5, 0.7}));
      world.gravity_W = {0, 0, 0};
      world.steps = 4;
      // From the surface of the ball, or from the middle of a face, an edge and a corner.
      std::vector<Eigen::Vector3d> directions_A = {{1, 0, 0}};
      if (left.index() != Shape{Sphere{1}}.index())
        directions_A.insert(directions_A.end(), {{0, 0.8, 0.6}, {0.6, 0.48, -0.64}});
      for (const Eigen::Vector3d& n_A : directions_A) {
        Eigen::Vector3d surface_A = 0.3 * n_A;
        if (const Box* const box = std::get_if<Box>(&left)) {
          const auto sign = [](double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; };
          surface_A = n_A.unaryExpr(sign).cwiseProduct(box->half_extents);
        }
        const Eigen::Vector3d n_W = X_WA.R_WB * n_A;
        const Eigen::Vector3d p_W = X_WA * surface_A;
        world.bodies[1].placed.X_WB.p_WB = p_W + (0.2 + s) * n_W;
        EXPECT_TRUE(PassWith(world, {{0, 0, 1, p_W + s / 2 * n_W, n_W, n_W, s}})) << s;
        const Eigen::Vector3d turned_W =
            Eigen::AngleAxisd(0.01, n_W.unitOrthogonal()) * n_W;
        EXPECT_TRUE(AreFoundWith(world, {{0, 0, 1, p_W + s / 2 * n_W, turned_W, n_W, s}}))
            << s;
      }
    }
  }
}

TEST(ContactsOnBodies, GrantsNothingForTheSpeedOfABodyThatTouchesNeither) {
  World world = Tilted(0.004, -0.002);
  RigidBody bullet = BodyOf("bullet", Sphere{0.01}, 0.01, 5 * kUp);
  bullet.v_WB = 1000 * kUp.unitOrthogonal();
  world.bodies.push_back(bullet);
  std::vector<ContactImpulse> contacts = Corners(world, 0.5);
  EXPECT_TRUE(PassWith(world, contacts));
  contacts[2].separation -= 1e-3;
  EXPECT_TRUE(AreFoundWith(world, contacts));
}

/** A ball at 1 m/s strikes a light one at rest, which then strikes a wall and comes to
 rest there in the same step. Its contact with the wall is off by `way` steps of 1 m/s. */
std::vector<LawFinding> StruckAndStopped(double way, bool is_struck) {
  World world;
  RigidBody heavy = BodyOf("heavy", Sphere{0.3}, 1000, {0, 0.7, 0});
  RigidBody light = BodyOf("light", Sphere{0.2}, 1, {0, 0.2, 0});
  heavy.v_WB = {0, -1, 0};
  world.bodies = {heavy, light, GroundOf(Eigen::Vector3d::UnitY())};
  world.gravity_W = {0, 0, 0};
  world.dt = 1e-3;
  world.steps = 1;
  Trajectory motion = Stepped(world, [](WorldState&) {});
  motion.gives_impulses = true;
  if (is_struck)
    motion.impulses.push_back({1, 0, 1, {0, 0.4, 0}, {0, -1, 0}, {0, -2, 0}, 0});
  motion.impulses.push_back({1, 2, 1, {0, 0, 0}, {0, 1, 0}, {0, 2, 0}, -way * world.dt});
  return Judge(world, motion, ClaimOf("contacts_on_bodies"));
}

TEST(ContactsOnBodies, GrantsTheSpeedThatAnImpactInTheStepGives) {
  EXPECT_TRUE(Passes(StruckAndStopped(1.9, true)));
  EXPECT_TRUE(Finds(StruckAndStopped(3.1, true), MeasureKind::kContactPlace));
  EXPECT_TRUE(Finds(StruckAndStopped(0.1, false), MeasureKind::kContactPlace));
}

TEST(ContactsOnBodies, GrantsTheMotionOfAStepAndJudgesOnlyThoseThatStartAtASample) {
  // The box comes down at 0.2 m/s, and contacts are those at the end of the step.
  World world = Tilted(0.004, 0.01);
  world.bodies[0].v_WB = -0.2 * kUp;
  Trajectory falls = Stepped(world, [&](WorldState& state) {
    state.bodies[0].p_WB += world.dt * state.bodies[0].v_WB;
  });
  falls.gives_impulses = true;
  World later = world;
  for (int step = 1; step <= world.steps; ++step) {
    later.bodies[0].placed.X_WB.p_WB -= 0.2 * world.dt * kUp;
    for (ContactImpulse contact : Corners(later, 0.5)) {
      contact.step = step;
      falls.impulses.push_back(contact);
    }
  }
  EXPECT_TRUE(Passes(Judge(world, falls, ClaimOf("contacts_on_bodies"))));
  // Deeper, since a line through a corner meets a side of the box a little higher.
  for (ContactImpulse& contact : falls.impulses) contact.separation -= 2e-3;
  EXPECT_TRUE(Finds(Judge(world, falls, ClaimOf("contacts_on_bodies")),
                    MeasureKind::kContactPlace));

  World rare = Tilted(0.004);
  rare.sample_every = 4;
  Trajectory rests = Resting(rare, Corners(rare, 0.5));
  for (ContactImpulse& contact : rests.impulses) {
    if (contact.step % 4 != 1) contact.separation = 1;
  }
  EXPECT_TRUE(Passes(Judge(rare, rests, ClaimOf("contacts_on_bodies"))));
}

/** Judges the contact of a ball that bounces off the ground in the middle of a step of
 10 ms. The contact is reported `aside` [m] of where the two touch then. */
LawFinding AtAnImpact(double aside) {
  World world;
  RigidBody ball = BodyOf("ball", Sphere{0.2}, 1, {0, 0.25, 0});
  ball.v_WB = {6, -10, 0};
  world.bodies = {ball, GroundOf(Eigen::Vector3d::UnitY())};
  world.gravity_W = {0, 0, 0};
  world.dt = 0.01;
  world.steps = 1;
  Trajectory motion = Stepped(world, [](WorldState& state) {
    state.bodies[0].p_WB.x() += 0.06;
    state.bodies[0].v_WB.y() = 10;
  });
  motion.gives_impulses = true;
  motion.impulses = {{1, 1, 0, {0.03 + aside, 0, 0}, {0, 1, 0}, {0, 20, 0}, 0}};
  return Of(Judge(world, motion, ClaimOf("contacts_on_bodies")),
            MeasureKind::kContactPlace);
}

// At either end of the step the ball is 5 cm above the ground.
TEST(ContactsOnBodies, KnowsTheMomentOfAnImpactWithinAStep) {
  EXPECT_LE(AtAnImpact(0).value, 1e-12);
  EXPECT_GE(AtAnImpact(0.3).value, 0.05);
  // The proof names the moment at which its numbers can be checked.
  EXPECT_THAT(AtAnImpact(0.3).proof,
              testing::HasSubstr("with the bodies where they are 0.01 s later, that"));
}

TEST(ContactsOnBodies, IsSilentAboutEnginesWithoutImpulsesAndAboutOtherShapes) {
  const World world = Tilted(0.004);
  Trajectory silent = Resting(world, {});
  silent.gives_impulses = false;
  EXPECT_TRUE(Judge(world, silent, ClaimOf("contacts_on_bodies")).empty());
  World other = world;
  other.bodies[0].placed.shape = Capsule{0.1, 0.2};
  EXPECT_EQ(FaultsOf(other, ClaimOf("contacts_on_bodies")).size(), 1U);
}

TEST(TurnsOnce, contacts_on_bodies) {
  const World world = Tilted(0.004, -0.003);
  EXPECT_TRUE(TurnsOnce(world, Resting(world, Corners(world, 0.5)),
                        ClaimOf("contacts_on_bodies")));
}

TEST(ContactsOnBodies, AScaledErrorTurnsTheVerdictOnce) {
  // Errors of a separation from 1e-3 to 1e3 of what is allowed: at rest a rounding of
  // either surface.
  const World world = Tilted(0.004, -0.003);
  const auto finding_with = [&](double error) {
    std::vector<ContactImpulse> contacts = Corners(world, 0.5);
    contacts[1].separation -= error;
    return Of(Judge(world, Resting(world, contacts), ClaimOf("contacts_on_bodies")),
              MeasureKind::kContactPlace);
  };
  const double tolerance = finding_with(1e-3).tolerance.value;
  for (const double scale : {1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3}) {
    const LawFinding finding = finding_with(2 * 1.1 * scale * tolerance);
    EXPECT_EQ(finding.value > finding.tolerance.value, scale >= 1) << scale;
  }
}

}  // namespace
}  // namespace touchstone
