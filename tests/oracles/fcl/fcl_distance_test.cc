#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/fcl/fcl_oracles.h"
#include "tests/oracles/constructed_contact.h"

namespace touchstone {
namespace {

constexpr double kGap = 2e-3;  // [m]

// A wrong sign or frame is off by the gap itself. The accuracy of FCL is not tested here.
constexpr Allowed kConventions = {kGap / 4, 0.05, kGap / 4};

const Oracle& Fcl(const std::string& name) {
  static const auto oracles = FclOracles();
  for (const auto& oracle : oracles) {
    if (oracle->info().name == name) return *oracle;
  }
  throw std::logic_error("there is no oracle " + name);
}

bool HasHalfSpace(ShapeKind a, ShapeKind b) {
  return a == ShapeKind::kHalfSpace || b == ShapeKind::kHalfSpace;
}

TEST(FclDistance, IsIsolatedWithEitherSolver) {
  for (const char* name : {"fcl/distance", "fcl/distance_indep", "fcl/signed_distance",
                           "fcl/signed_distance_indep"}) {
    EXPECT_TRUE(Fcl(name).info().isolated) << name;
  }
}

TEST(FclDistance, ReturnsDistanceAndWitnessesIfApartAndOnlyTouchingOtherwise) {
  for (const char* name : {"fcl/distance", "fcl/distance_indep"}) {
    for (const auto& [a, b] : AllPairs()) {
      if (HasHalfSpace(a, b)) continue;
      SCOPED_TRACE(std::string(name) + ": " + std::string(NameOf(a)) + " against " +
                   std::string(NameOf(b)));
      const ConstructedContact apart = PutTogether(a, b, kGap);
      ContactAnswer answer = Fcl(name).Answer(apart.query);
      ExpectMatches(answer, apart, kConventions);
      EXPECT_TRUE(answer.separation && answer.witnesses);

      const ConstructedContact deep = PutTogether(a, b, -kGap);
      answer = Fcl(name).Answer(deep.query);
      ExpectMatches(answer, deep, kConventions);
      EXPECT_FALSE(answer.separation || answer.witnesses || answer.n_AB_W);
    }
  }
}

TEST(FclSignedDistance, NormalPointsFromAToBBothApartAndPenetrating) {
  const Oracle& fcl = Fcl("fcl/signed_distance");
  for (const auto& [a, b] : AllPairs()) {
    if (HasHalfSpace(a, b)) continue;
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    for (const double separation : {-kGap, kGap}) {
      const ConstructedContact truth = PutTogether(a, b, separation);
      const ContactAnswer answer = fcl.Answer(truth.query);
      ExpectMatches(answer, truth, kConventions);
      EXPECT_TRUE(answer.separation && answer.witnesses && answer.n_AB_W);
    }
  }
}

// The nearest points of boxes that just touch are one point: the direction between them
// is only rounding.
TEST(FclSignedDistance, ReturnsNoNormalIfItsNearestPointsCoincide) {
  const ConstructedContact touching = PutTogether(ShapeKind::kBox, ShapeKind::kBox, 0);
  const ContactAnswer answer = Fcl("fcl/signed_distance").Answer(touching.query);
  ASSERT_EQ(answer.status, AnswerStatus::kAnswered) << answer.reason;
  EXPECT_FALSE(answer.n_AB_W);
}

TEST(FclSignedDistanceIndep, ReturnsDepthButNoNormal) {
  const ConstructedContact deep = PutTogether(ShapeKind::kSphere, ShapeKind::kBox, -kGap);
  const ContactAnswer answer = Fcl("fcl/signed_distance_indep").Answer(deep.query);
  ExpectMatches(answer, deep, kConventions);
  EXPECT_TRUE(answer.separation);
  EXPECT_FALSE(answer.n_AB_W || answer.witnesses);
}

// flexible-collision-library/fcl#623: the support function of a half-space is a null
// pointer.
TEST(FclDistance, CrashesOnAHalfSpaceButTheRunSurvives) {
  const std::vector<ContactQuery> queries = {
      PutTogether(ShapeKind::kSphere, ShapeKind::kBox, kGap).query,
      PutTogether(ShapeKind::kBox, ShapeKind::kHalfSpace, kGap).query,
      PutTogether(ShapeKind::kBox, ShapeKind::kSphere, kGap).query};
  for (const char* name : {"fcl/distance", "fcl/signed_distance"}) {
    std::vector<ContactAnswer> answers(queries.size());
    Fcl(name).Answer(queries, answers);
    EXPECT_EQ(answers[0].status, AnswerStatus::kAnswered);
    EXPECT_EQ(answers[1].status, AnswerStatus::kCrashed);
    EXPECT_EQ(answers[2].status, AnswerStatus::kAnswered);
  }
}

TEST(FclDistance, PreparedBatchReturnsTheSeparationsOfTheAnswers) {
  const Oracle& fcl = Fcl("fcl/distance");
  std::vector<ContactQuery> queries;
  for (const double separation : {-0.1, 0.003, 0.2}) {
    queries.push_back(PutTogether(ShapeKind::kBox, ShapeKind::kCone, separation).query);
  }
  const auto batch = fcl.Prepare(queries);
  batch->Run();
  EXPECT_TRUE(std::isnan(batch->separations()[0]));
  for (const std::size_t i : {1u, 2u}) {
    EXPECT_EQ(batch->separations()[i], fcl.Answer(queries[i]).separation);
  }
}

}  // namespace
}  // namespace touchstone
