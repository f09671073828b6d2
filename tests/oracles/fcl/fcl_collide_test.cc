#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/fcl/fcl_contact_point.h"
#include "oracles/fcl/fcl_oracles.h"
#include "tests/oracles/constructed_contact.h"
#include "tests/oracles/surface.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// A few dozen roundings of numbers of a few metres.
constexpr double kRounding = 64 * 4 * 0x1p-53;  // [m]

const Oracle& Fcl(const std::string& name) {
  static const auto oracles = FclOracles();
  for (const auto& oracle : oracles) {
    if (oracle->info().name == name) return *oracle;
  }
  throw std::logic_error("there is no oracle " + name);
}

// The tolerances that FCL documents, or that follow from its formulas, for bodies that
// overlap by `depth`.
Allowed AllowedFor(const Capability& capability, double depth) {
  if (capability.documented_error == 0) return {kRounding, kRounding, kRounding};
  // For MPR, the point is somewhere in the overlap. Features are at least 0.2 m wide, so
  // a depth error in metres allows a normal error of 5 times as many radians.
  const double error = kRounding + capability.documented_error;
  return {error, error / 0.2, depth / 2 + error};
}

bool IsSphereAndCapsule(ShapeKind a, ShapeKind b) {
  return (a == ShapeKind::kSphere && b == ShapeKind::kCapsule) ||
         (a == ShapeKind::kCapsule && b == ShapeKind::kSphere);
}

class FclCollide : public testing::TestWithParam<std::string> {};

TEST_P(FclCollide, AnswersInTheProjectsConventions) {
  const Oracle& fcl = Fcl(GetParam());
  int judged = 0;
  for (const auto& [a, b] : AllPairs()) {
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    const Capability& capability = fcl.info().For(a, b);
    EXPECT_EQ(capability.supported, !(a == ShapeKind::kHalfSpace && a == b));
    // The next test covers the family "gjk_epa".
    if (!capability.supported || capability.family == "gjk_epa") continue;
    ++judged;
    const ConstructedContact deep = PutTogether(a, b, -2e-3);
    ContactAnswer answer = fcl.Answer(deep.query);
    EXPECT_TRUE(answer.separation && answer.n_AB_W);
    EXPECT_FALSE(answer.points.empty());
    Allowed allowed = AllowedFor(capability, 2e-3);
    // FCL puts this point next to the capsule's axis, up to 0.37 m from the overlap.
    if (IsSphereAndCapsule(a, b)) allowed.point = 0.37;
    ExpectMatches(answer, deep, allowed);

    const ConstructedContact apart = PutTogether(a, b, 2e-3);
    answer = fcl.Answer(apart.query);
    ExpectMatches(answer, apart, allowed);
    EXPECT_FALSE(answer.separation);
    EXPECT_TRUE(answer.points.empty());
  }
  // All 48 pairs, or those with a closed form: a sphere with four kinds, a half-space
  // with six kinds, and two boxes.
  EXPECT_EQ(judged, GetParam() == "fcl/collide" ? 48 : 7 + 12 + 1);
}

INSTANTIATE_TEST_SUITE_P(BothSolvers, FclCollide,
                         testing::Values("fcl/collide", "fcl/collide_indep"),
                         [](const auto& test) { return test.param.substr(4); });

// FCL pull request #334: GST_INDEP's EPA returns the depth with the wrong sign and the
// normal in a body frame. The adapter must not repair this.
TEST(FclCollideIndep, PassesOnTheNegativeDepthsOfItsEpa) {
  const Oracle& fcl = Fcl("fcl/collide_indep");
  const ConstructedContact deep =
      PutTogether(ShapeKind::kCapsule, ShapeKind::kBox, -2e-3);
  const ContactAnswer answer = fcl.Answer(deep.query);
  EXPECT_TRUE(answer.touching);
  ASSERT_TRUE(answer.separation);
  EXPECT_GT(*answer.separation, 0);
}

// For pairs on which FCL is exact, p ± n depth/2 are on the surfaces, at any depth and
// orientation.
TEST(FclCollideOracle, PutsEveryContactMidwayThroughItsOverlap) {
  const Oracle& fcl = Fcl("fcl/collide");
  std::mt19937_64 random(20240611);
  const ShapeKind sphere = ShapeKind::kSphere;
  const ShapeKind box = ShapeKind::kBox;
  const ShapeKind half_space = ShapeKind::kHalfSpace;
  const std::pair<ShapeKind, ShapeKind> pairs[] = {{sphere, sphere},
                                                   {sphere, box},
                                                   {ShapeKind::kCylinder, sphere},
                                                   {sphere, half_space},
                                                   {half_space, ShapeKind::kCapsule},
                                                   {ShapeKind::kCylinder, half_space},
                                                   {ShapeKind::kConvexHull, half_space},
                                                   {box, half_space},
                                                   {box, box}};
  for (const auto& [a, b] : pairs) {
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    int contacts = 0;
    for (int i = 0; i < 300; ++i) {
      const ContactQuery query = {{RandomShape(a, random), RandomPose(0.8, random)},
                                  {RandomShape(b, random), RandomPose(0.8, random)}};
      const ContactAnswer answer = fcl.Answer(query);
      ASSERT_EQ(answer.status, AnswerStatus::kAnswered);
      for (const ContactPoint& point : answer.points) {
        const Vector3d half_gap_W = point.separation / 2 * *answer.n_AB_W;
        // The crossing point of two edges is computed with a division by sin² of their
        // angle, which is > 1e-5 here.
        constexpr double kIllConditioned = kRounding / 1e-5;
        EXPECT_NEAR(HeightAboveSurface(query.A, point.p_WC - half_gap_W), 0,
                    kIllConditioned);
        EXPECT_NEAR(HeightAboveSurface(query.B, point.p_WC + half_gap_W), 0,
                    kIllConditioned);
        ++contacts;
      }
    }
    EXPECT_GT(contacts, 100);
  }
}

TEST(FclContactPoint, KeepsTheErrorOfAPointAlongItsNormal) {
  const FclContact right = {{0.5, 0, 0}, {1, 0, 0}, 0.3};
  FclContact off = right;
  off.p_W.x() += 1e-3;
  const auto at_x = [](double radius, double x) {
    return Body{Sphere{radius}, Pose::FromQuaternion({x, 0, 0}, {1, 0, 0, 0})};
  };
  // The overlap is from x = 0.45 to 0.75. FCL's point is at 0.65, a third of the depth
  // inside A; the adapter's is at 0.6.
  const ContactQuery spheres = {at_x(0.75, 0), at_x(1.5, 1.95)};
  EXPECT_NEAR(MidwayPoint(spheres, {{0.65, 0, 0}, {1, 0, 0}, 0.3}).x(), 0.6, kRounding);
  EXPECT_NEAR(MidwayPoint(spheres, off).x() - MidwayPoint(spheres, right).x(), 1e-3,
              kRounding);
}

TEST(FclCollideOracle, DoesNotSupportAFlatHull) {
  ConstructedContact contact =
      PutTogether(ShapeKind::kConvexHull, ShapeKind::kBox, -2e-3);
  contact.query.A.shape = ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const ContactAnswer answer = Fcl("fcl/collide").Answer(contact.query);
  EXPECT_EQ(answer.status, AnswerStatus::kUnsupported);
  EXPECT_FALSE(answer.reason.empty());
}

TEST(FclCollideOracle, PreparedBatchReturnsTheSeparationsOfTheAnswers) {
  const Oracle& fcl = Fcl("fcl/collide");
  std::mt19937_64 random(5);
  std::vector<ContactQuery> queries;
  for (int i = 0; i < 200; ++i) {
    queries.push_back(
        {{RandomShape(ShapeKind::kBox, random), RandomPose(0.8, random)},
         {RandomShape(ShapeKind::kSphere, random), RandomPose(0.8, random)}});
  }
  const auto batch = fcl.Prepare(queries);
  batch->Run();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const ContactAnswer answer = fcl.Answer(queries[i]);
    EXPECT_EQ(std::isnan(batch->separations()[i]), !answer.touching);
    if (answer.touching) {
      EXPECT_EQ(batch->separations()[i], answer.separation);
    }
  }
}

}  // namespace
}  // namespace touchstone
