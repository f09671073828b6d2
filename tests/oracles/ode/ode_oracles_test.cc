#include "oracles/ode/ode_oracles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/ode/ode_contact_point.h"
#include "tests/oracles/constructed_contact.h"
#include "tests/oracles/surface.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// A few dozen roundings of numbers of a few metres.
constexpr double kRounding = 64 * 4 * 0x1p-53;  // [m]

const Oracle& Ode() {
  static const auto oracles = OdeOracles();
  return *oracles.front();
}

// The tolerances that ODE documents, or that follow from its formulas, for bodies that
// overlap by `depth`.
Allowed AllowedFor(ShapeKind a, ShapeKind b, double depth) {
  const Capability& capability = Ode().info().For(a, b);
  if (capability.family == "mpr") {
    // The point is somewhere in the overlap. Features are at least 0.2 m wide, so a depth
    // error in metres allows a normal error of 5 times as many radians.
    const double error = kRounding + capability.documented_error;
    return {error, error / 0.2, depth / 2 + error};
  }
  if (capability.family == "cylinder_box_sat") {
    // ODE computes sin as sqrt(1 − cos²): the error is sqrt of two roundings, times the
    // radius.
    const double error = 0.35 * std::sqrt(2 * 0x1p-53) + kRounding;
    return {error, kRounding, error};
  }
  return {kRounding, kRounding, kRounding};
}

bool IsSupported(ShapeKind a, ShapeKind b) {
  return Ode().info().For(a, b).supported;
}

TEST(OdeOracle, AnswersInTheProjectsConventions) {
  int supported = 0;
  for (const auto& [a, b] : AllPairs()) {
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    if (!IsSupported(a, b)) continue;
    ++supported;
    const ConstructedContact deep = PutTogether(a, b, -2e-3);
    ContactAnswer answer = Ode().Answer(deep.query);
    EXPECT_TRUE(answer.separation && answer.n_AB_W);
    EXPECT_FALSE(answer.points.empty());
    ExpectMatches(answer, deep, AllowedFor(a, b, 2e-3));

    const ConstructedContact apart = PutTogether(a, b, 2e-3);
    answer = Ode().Answer(apart.query);
    ExpectMatches(answer, apart, AllowedFor(a, b, 0));
    EXPECT_FALSE(answer.separation);
    EXPECT_TRUE(answer.points.empty());
  }
  EXPECT_EQ(supported, 6 * 6 - 1);  // All pairs without a cone, except two planes.
}

// For pairs on which ODE is exact, p ± n depth/2 are on the surfaces, at any depth and
// orientation.
TEST(OdeOracle, PutsEveryContactMidwayThroughItsOverlap) {
  std::mt19937_64 random(20240611);
  const ShapeKind sphere = ShapeKind::kSphere;
  const ShapeKind box = ShapeKind::kBox;
  const std::pair<ShapeKind, ShapeKind> pairs[] = {
      {sphere, sphere},
      {sphere, box},
      {box, sphere},
      {sphere, ShapeKind::kCapsule},
      {ShapeKind::kCylinder, sphere},
      {sphere, ShapeKind::kHalfSpace},
      {box, box},
      {ShapeKind::kHalfSpace, box},
      {ShapeKind::kConvexHull, ShapeKind::kHalfSpace}};
  for (const auto& [a, b] : pairs) {
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    int contacts = 0;
    int off_surface = 0;
    for (int i = 0; i < 300; ++i) {
      const ContactQuery query = {{RandomShape(a, random), RandomPose(0.8, random)},
                                  {RandomShape(b, random), RandomPose(0.8, random)}};
      const ContactAnswer answer = Ode().Answer(query);
      ASSERT_EQ(answer.status, AnswerStatus::kAnswered);
      for (const ContactPoint& point : answer.points) {
        const Vector3d half_gap_W = point.separation / 2 * *answer.n_AB_W;
        const double height_A = HeightAboveSurface(query.A, point.p_WC - half_gap_W);
        const double height_B = HeightAboveSurface(query.B, point.p_WC + half_gap_W);
        // The crossing point of two edges is computed with a division by sin² of their
        // angle, which is > 1e-5 here.
        constexpr double kIllConditioned = kRounding / 1e-5;
        if (std::max(std::abs(height_A), std::abs(height_B)) > kIllConditioned)
          ++off_surface;
        ++contacts;
      }
    }
    EXPECT_GT(contacts, 100);
    // dBoxBox() keeps the first pair of edges within 5 % of the best. If it is not the
    // best, its lines cross beyond the ends of the edges: measured for 3 of 5126
    // contacts.
    EXPECT_LE(off_surface, a == box && b == box ? contacts / 200 : 0);
  }
}

// The adapter moves a sphere's contact along the normal. If it moved the contact to the
// right place, no measure could detect that ODE had put it elsewhere.
TEST(OdeContactPoint, KeepsTheErrorOfASpheresPointAlongItsNormal) {
  constexpr double kOff = 1e-3;  // [m]
  std::mt19937_64 random(20240612);
  for (const auto& [a, b] : AllPairs()) {
    if ((a != ShapeKind::kSphere && b != ShapeKind::kSphere) || !IsSupported(a, b))
      continue;
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    int contacts = 0;
    int hidden = 0;
    for (int i = 0; i < 300; ++i) {
      const ContactQuery query = {{RandomShape(a, random), RandomPose(0.8, random)},
                                  {RandomShape(b, random), RandomPose(0.8, random)}};
      const ContactAnswer answer = Ode().Answer(query);
      if (!answer.touching || *answer.separation > -50 * kOff) continue;
      const Vector3d& n = *answer.n_AB_W;
      const double depth = -*answer.separation;
      const Vector3d& midway = answer.points[0].p_WC;
      // The places where ODE may have put it: on A, midway, on B, at a centre.
      for (const Vector3d& place :
           {Vector3d(midway + depth / 2 * n), midway, Vector3d(midway - depth / 2 * n),
            query.A.X_WB.p_WB, query.B.X_WB.p_WB}) {
        if (!MidwayPoint(query, {place, n, depth}).isApprox(midway, kRounding)) continue;
        const Vector3d off = MidwayPoint(query, {place + kOff * n, n, depth});
        ++contacts;
        if (!off.isApprox(midway + kOff * n, kRounding)) ++hidden;
      }
    }
    EXPECT_GT(contacts, 100);
    // A cylinder has several possible places, and two of them may be as close to each
    // other as the point is off.
    const bool cylinder = a == ShapeKind::kCylinder || b == ShapeKind::kCylinder;
    EXPECT_LE(hidden, cylinder ? contacts / 50 : 0);
  }
}

TEST(OdeOracle, SupportsHullsWhoseOriginIsFarOutside) {
  const ConstructedContact near =
      PutTogether(ShapeKind::kConvexHull, ShapeKind::kBox, -2e-3);
  ConstructedContact far = near;
  const Vector3d offset(3, -2, 5);
  for (Vector3d& vertex : std::get<ConvexHull>(far.query.A.shape).vertices)
    vertex += offset;
  far.query.A.X_WB.p_WB -= far.query.A.X_WB.R_WB * offset;
  ExpectMatches(Ode().Answer(far.query), far,
                AllowedFor(ShapeKind::kConvexHull, ShapeKind::kBox, 2e-3));
}

TEST(OdeOracle, DoesNotSupportAFlatHull) {
  ConstructedContact contact =
      PutTogether(ShapeKind::kConvexHull, ShapeKind::kBox, -2e-3);
  contact.query.A.shape = ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const ContactAnswer answer = Ode().Answer(contact.query);
  EXPECT_EQ(answer.status, AnswerStatus::kUnsupported);
  EXPECT_FALSE(answer.reason.empty());
}

TEST(OdeOracle, PreparedBatchReturnsTheSeparationsOfTheAnswers) {
  std::mt19937_64 random(5);
  std::vector<ContactQuery> queries;
  for (int i = 0; i < 200; ++i) {
    queries.push_back(
        {{RandomShape(ShapeKind::kBox, random), RandomPose(0.8, random)},
         {RandomShape(ShapeKind::kSphere, random), RandomPose(0.8, random)}});
  }
  const auto batch = Ode().Prepare(queries);
  batch->Run();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const ContactAnswer answer = Ode().Answer(queries[i]);
    EXPECT_EQ(std::isnan(batch->separations()[i]), !answer.touching);
    if (answer.touching) {
      EXPECT_EQ(batch->separations()[i], answer.separation);
    }
  }
}

}  // namespace
}  // namespace touchstone
