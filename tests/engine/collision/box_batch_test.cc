// A batch of box pairs returns the same bits as one pair at a time, on every SIMD target.

#include "engine/collision/box_batch.h"

#include <bit>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "tests/engine/on_target.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

std::vector<BoxQuestion> Questions(int per_family) {
  std::vector<BoxQuestion> questions;
  Random random(3);
  for (const Family& family : Families()) {
    for (int k = 0; k < per_family; ++k) questions.push_back(family.draw(random));
  }
  return questions;
}

BoxBatch BatchOf(const std::vector<BoxQuestion>& questions) {
  BoxBatch batch(questions.size());
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const BoxQuestion& q = questions[k];
    batch.Set(k, q.A, q.X_WA, q.B, q.X_WB);
  }
  batch.FindGaps();
  return batch;
}

std::uint64_t Bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

void ExpectSameBits(const BoxGap& a, const BoxGap& b) {
  EXPECT_EQ(Bits(a.separation), Bits(b.separation));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(Bits(a.n_AB_W[k]), Bits(b.n_AB_W[k]));
}

using BoxBatchOnTarget = OnTarget;

TEST_P(BoxBatchOnTarget, ReturnsTheBitsOfOnePairAtATime) {
  const std::vector<BoxQuestion> questions = Questions(1000);
  const BoxBatch batch = BatchOf(questions);
  for (std::size_t k = 0; k < questions.size() && !HasFailure(); ++k) {
    const BoxQuestion& q = questions[k];
    ExpectSameBits(batch.gap(k), FindGap(q.A, q.X_WA, q.B, q.X_WB));
  }
}

TEST_P(BoxBatchOnTarget, ContactsHaveTheBitsOfTheWidestVectors) {
  for (const BoxQuestion& q : Questions(300)) {
    Choose(GetParam());
    const Manifold narrow = Collide(q.A, q.X_WA, q.B, q.X_WB);
    Choose(kAll);
    const Manifold wide = Collide(q.A, q.X_WA, q.B, q.X_WB);
    ASSERT_EQ(narrow.count, wide.count);
    EXPECT_EQ(Bits(narrow.separation), Bits(wide.separation));
    for (std::size_t k = 0; k < wide.points().size(); ++k) {
      const ContactPoint& a = narrow.contacts[k];
      const ContactPoint& b = wide.contacts[k];
      EXPECT_EQ(a.feature, b.feature);
      EXPECT_EQ(Bits(a.separation), Bits(b.separation));
      for (int n = 0; n < 3; ++n) EXPECT_EQ(Bits(a.p_WC[n]), Bits(b.p_WC[n]));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, BoxBatchOnTarget, testing::ValuesIn(Targets()),
                         NameOfTarget);

TEST(BoxBatch, EveryPairOfAPartlyFilledBlockIsAnswered) {
  const std::vector<BoxQuestion> all = Questions(2);
  for (std::size_t count = 0; count <= all.size(); ++count) {
    const std::vector<BoxQuestion> questions(
        all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    const BoxBatch batch = BatchOf(questions);
    ASSERT_EQ(batch.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
      const BoxQuestion& q = questions[k];
      ExpectSameBits(batch.gap(k), FindGap(q.A, q.X_WA, q.B, q.X_WB));
      EXPECT_EQ(batch.separations()[k], batch.gap(k).separation);
    }
  }
}

TEST(BoxBatch, TouchingBoxesHaveTheBitsOfTheirManifold) {
  int touching = 0;
  for (const BoxQuestion& q : Questions(500)) {
    const Manifold manifold = Collide(q.A, q.X_WA, q.B, q.X_WB);
    const BoxGap gap = FindGap(q.A, q.X_WA, q.B, q.X_WB);
    ASSERT_EQ(manifold.touching, gap.separation <= 0);
    if (manifold.touching) {
      ++touching;
      ExpectSameBits(gap, {manifold.separation, manifold.n_AB_W});
    } else {
      EXPECT_LE(manifold.separation, gap.separation * (1 + 1e-15));
    }
  }
  EXPECT_GT(touching, 1000);
}

}  // namespace
}  // namespace cookbook::test
