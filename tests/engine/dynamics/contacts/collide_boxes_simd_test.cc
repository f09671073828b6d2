#include "engine/dynamics/contacts/collide_boxes_simd.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "engine/collision/rounding.h"
#include "tests/engine/on_target.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

/** Two bodies and their manifold. */
struct Pair {
  RigidBody A;
  RigidBody B;
  Manifold manifold;
  bool edge_contact = false;
};

RigidBody BodyOf(const Box& box, const Pose& X_WO) {
  BodyDefinition definition;
  definition.shape = box;
  RigidBody body = MakeRigidBody(definition);
  body.state.p_WB = X_WO.p_WB;
  body.R_WB = X_WO.R_WB;
  return body;
}

Pair PairOf(const BoxQuestion& q) {
  return {BodyOf(q.A, q.X_WA), BodyOf(q.B, q.X_WB), {}};
}

/** Collides at most kPairsPerBatch pairs as one batch. */
void CollideBatch(double margin, std::span<Pair> pairs) {
  std::vector<CollisionPair> batch;
  for (Pair& pair : pairs) {
    batch.push_back({&pair.A, &pair.B, margin, Eigen::Vector3d::Zero(), &pair.manifold});
  }
  const unsigned edge_contact = CollideBoxesSimd(batch);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    pairs[k].edge_contact = (edge_contact >> k & 1) != 0;
  }
}

Pair CollideAlone(double margin, const BoxQuestion& q) {
  Pair pair = PairOf(q);
  CollideBatch(margin, std::span(&pair, 1));
  return pair;
}

std::uint64_t Bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

void ExpectSameBits(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  for (int k = 0; k < 3; ++k) EXPECT_EQ(Bits(a[k]), Bits(b[k]));
}

void ExpectSameBits(const Pair& a, const Pair& b) {
  EXPECT_EQ(a.edge_contact, b.edge_contact);
  EXPECT_EQ(a.manifold.touching, b.manifold.touching);
  EXPECT_EQ(Bits(a.manifold.separation), Bits(b.manifold.separation));
  ExpectSameBits(a.manifold.n_AB_W, b.manifold.n_AB_W);
  ASSERT_EQ(a.manifold.count, b.manifold.count);
  for (std::size_t k = 0; k < a.manifold.points().size(); ++k) {
    const ContactPoint& p = a.manifold.contacts[k];
    const ContactPoint& q = b.manifold.contacts[k];
    ExpectSameBits(p.p_WC, q.p_WC);
    EXPECT_EQ(Bits(p.separation), Bits(q.separation));
    EXPECT_EQ(p.feature, q.feature);
  }
}

constexpr double kMargin = 1e-3;

/** Returns pairs of all families: in each round one pair of each family, then a batch of
 random families. */
std::vector<BoxQuestion> RandomPairs(int rounds) {
  std::vector<BoxQuestion> questions;
  Random random(7);
  for (int round = 0; round < rounds; ++round) {
    for (const Family& family : Families()) questions.push_back(family.draw(random));
    for (std::size_t k = 0; k < kPairsPerBatch; ++k)
      questions.push_back(AnyBoxes(random));
  }
  return questions;
}

using CollideBoxesOnTarget = OnTarget;

TEST_P(CollideBoxesOnTarget, ABatchHasTheBitsOfEachPairAloneOnTheBestTarget) {
  const std::vector<BoxQuestion> questions = RandomPairs(200);
  int contacts = 0;
  // Batches of 1, 2, … 8, 1, 2, … pairs.
  for (std::size_t first = 0, size = 1; first < questions.size() && !HasFailure();
       first += size, size = size % kPairsPerBatch + 1) {
    std::vector<Pair> pairs;
    for (std::size_t k = first; k < std::min(first + size, questions.size()); ++k) {
      pairs.push_back(PairOf(questions[k]));
    }
    Choose(GetParam());
    CollideBatch(kMargin, pairs);
    Choose(kAll);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      ExpectSameBits(pairs[k], CollideAlone(kMargin, questions[first + k]));
      contacts += pairs[k].manifold.count;
    }
  }
  EXPECT_GT(contacts, 1000);
}

INSTANTIATE_TEST_SUITE_P(, CollideBoxesOnTarget, testing::ValuesIn(Targets()),
                         NameOfTarget);

/** Returns the signed distance from a point to the planes of a box's faces: < 0 inside.
 */
double DistanceToFaces(const RigidBody& body, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d p_B = body.R_WB.transpose() * (p_W - body.state.p_WB);
  return (p_B.cwiseAbs() - std::get<Box>(body.shape).half_extents).maxCoeff();
}

TEST(CollideBoxesSimd, ContactsAreMidwayBetweenTheSurfaces) {
  Random random(11);
  int contacts = 0;
  for (int n = 0; n < 2000 && !testing::Test::HasFailure(); ++n) {
    const Pair pair = CollideAlone(kMargin, AnyBoxes(random));
    for (const ContactPoint& contact : pair.manifold.points()) {
      const Eigen::Vector3d half = 0.5 * contact.separation * pair.manifold.n_AB_W;
      EXPECT_GE(contact.separation, pair.manifold.separation);
      EXPECT_LE(contact.separation, kMargin);
      // Corners may be outside by a thousandth of the margin, and are moved back to the
      // reference face. The other face is tilted by at most 55°, so its surface is 1.7
      // times as far. The rest is rounding.
      const double slop = 1e-3 * kMargin * 2;
      EXPECT_NEAR(DistanceToFaces(pair.A, contact.p_WC - half), 0, slop);
      EXPECT_NEAR(DistanceToFaces(pair.B, contact.p_WC + half), 0, slop);
      ++contacts;
    }
  }
  EXPECT_GT(contacts, 2000);
}

// The end of a long bar that leans on an edge at a small angle is far below the face, and
// an impulse along the normal of that face would not stop the bar.
TEST(CollideBoxesSimd, AFaceIsNotMuchDeeperThanTheEdgesThatItReplaces) {
  Random random(12);
  int faces_for_edges = 0;
  int edges = 0;
  for (int n = 0; n < 20000 && !testing::Test::HasFailure(); ++n) {
    const BoxQuestion q = AnyBoxes(random);
    const Manifold least = Collide(q.A, q.X_WA, q.B, q.X_WB);
    if (!least.touching) continue;
    const Pair pair = CollideAlone(kMargin, q);
    const double thinnest =
        std::min(q.A.half_extents.minCoeff(), q.B.half_extents.minCoeff());
    EXPECT_GE(pair.manifold.separation,
              least.separation - std::max(kMargin, 0.05 * thinnest) - 1e-12);
    faces_for_edges += pair.manifold.separation < least.separation - 1e-9;
    edges += pair.edge_contact;
  }
  EXPECT_GT(faces_for_edges, 10);
  EXPECT_GT(edges, 1000);
}

TEST(CollideBoxesSimd, WithoutMarginFaceContactsAreThoseOfCollide) {
  Random random(13);
  int compared = 0;
  for (int n = 0; n < 2000 && !testing::Test::HasFailure(); ++n) {
    const BoxQuestion q = AnyBoxes(random);
    const Manifold expected = Collide(q.A, q.X_WA, q.B, q.X_WB);
    const Pair pair = CollideAlone(0, q);
    ASSERT_EQ(pair.manifold.touching, expected.touching);
    // For two edges of nearly parallel faces the SIMD version has a patch.
    if (!expected.touching || pair.edge_contact ||
        !pair.manifold.n_AB_W.isApprox(expected.n_AB_W, 1e-12)) {
      continue;
    }
    ASSERT_EQ(pair.manifold.count, expected.count);
    for (std::size_t k = 0; k < expected.points().size(); ++k) {
      const ContactPoint& contact = pair.manifold.contacts[k];
      EXPECT_EQ(contact.feature, expected.contacts[k].feature);
      EXPECT_LT((contact.p_WC - expected.contacts[k].p_WC).norm(), 1e-12);
      EXPECT_NEAR(contact.separation, expected.contacts[k].separation, 1e-12);
    }
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

/** A cube of 1 m above another, rotated about the vertical, at the distance `gap`. */
BoxQuestion CubeAboveCube(double angle, double gap) {
  const Box cube{{0.5, 0.5, 0.5}};
  return {cube,
          {Eigen::Matrix3d::Identity(), {0, 0, 0}},
          cube,
          {Turn(Eigen::Vector3d::UnitY(), angle), {0, 1 + gap, 0}}};
}

TEST(CollideBoxesSimd, FlushFacesHaveFourContactsAtTheirCorners) {
  const Pair pair = CollideAlone(kMargin, CubeAboveCube(0, 0));
  ASSERT_EQ(pair.manifold.count, 4);
  EXPECT_EQ(pair.manifold.n_AB_W, Eigen::Vector3d::UnitY());
  for (const ContactPoint& contact : pair.manifold.points()) {
    EXPECT_EQ(contact.separation, 0);
    EXPECT_EQ(contact.p_WC.cwiseAbs(), Eigen::Vector3d(0.5, 0.5, 0.5));
  }
}

TEST(CollideBoxesSimd, FacesRotatedByAnEighthTurnHaveAnOctagonOfContacts) {
  const Pair pair = CollideAlone(kMargin, CubeAboveCube(std::numbers::pi / 4, 0.5e-3));
  ASSERT_EQ(pair.manifold.count, 8);
  EXPECT_FALSE(pair.manifold.touching);
  const double near = std::numbers::sqrt2 / 2 - 0.5;
  for (const ContactPoint& contact : pair.manifold.points()) {
    EXPECT_NEAR(contact.separation, 0.5e-3, 1e-15);
    EXPECT_NEAR(contact.p_WC.y(), 0.5 + 0.25e-3, 1e-15);
    const double x = std::abs(contact.p_WC.x());
    const double z = std::abs(contact.p_WC.z());
    EXPECT_NEAR(std::max(x, z), 0.5, 1e-15);
    // Along the edge within the tolerance for flush corners.
    EXPECT_NEAR(std::min(x, z), near, 1e-3 * kMargin + 1e-15);
  }
}

TEST(CollideBoxesSimd, FacesSeparatedByMoreThanTheMarginHaveNoContact) {
  const Pair pair = CollideAlone(kMargin, CubeAboveCube(0.3, 1.1 * kMargin));
  EXPECT_EQ(pair.manifold.count, 0);
  EXPECT_FALSE(pair.edge_contact);
  EXPECT_NEAR(pair.manifold.separation, 1.1 * kMargin, 1e-15);
}

TEST(CollideBoxesSimd, CrossingEdgesAreLeftToTheCaller) {
  // Each cube stands on an edge. The lower edge of B crosses the upper edge of A at 90°.
  const Box cube{{0.5, 0.5, 0.5}};
  const Eigen::Matrix3d on_edge = Turn(Eigen::Vector3d::UnitZ(), std::numbers::pi / 4);
  const double gap = 0.5 * kMargin;
  const BoxQuestion q{cube,
                      {on_edge, {0, 0, 0}},
                      cube,
                      {Turn(Eigen::Vector3d::UnitY(), std::numbers::pi / 2) * on_edge,
                       {0, std::numbers::sqrt2 + gap, 0}}};
  const Pair pair = CollideAlone(kMargin, q);
  EXPECT_TRUE(pair.edge_contact);
  EXPECT_EQ(pair.manifold.count, 0);
  EXPECT_NEAR(pair.manifold.separation, gap, 1e-15);
  EXPECT_LT((pair.manifold.n_AB_W - Eigen::Vector3d::UnitY()).norm(), 1e-15);
}

TEST(CollideBoxesSimd, TheReferenceFaceOfTheLastStepIsKeptWithinTheMargin) {
  // B is tilted. The gaps along the normals of A and B differ by a tenth of the margin.
  const Box cube{{0.5, 0.5, 0.5}};
  const Eigen::Matrix3d tilted = Turn(Eigen::Vector3d::UnitZ(), 1e-3);
  for (const bool was_B : {false, true}) {
    Pair pair = PairOf({cube,
                        {Eigen::Matrix3d::Identity(), {0, 0, 0}},
                        cube,
                        {tilted, {0, 1 + 0.4e-3, 0}}});
    const Eigen::Vector3d n_A = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d n_B = tilted.col(1);
    const Eigen::Vector3d guess = was_B ? n_B : n_A;
    const CollisionPair batch{&pair.A, &pair.B, kMargin, guess, &pair.manifold};
    CollideBoxesSimd(std::span(&batch, 1));
    EXPECT_LT((pair.manifold.n_AB_W - guess).norm(), 1e-15) << was_B;
  }
}

}  // namespace
}  // namespace cookbook::test
