// A batch of sphere pairs returns the same bits as one pair at a time, on every SIMD
// target.

#include "engine/collision/sphere_batch.h"

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "tests/engine/on_target.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

struct SphereQuestion {
  Sphere A;
  Pose X_WA;
  Sphere B;
  Pose X_WB;
};

/** Returns pairs near and far; the centres of every fifth are at most 1e-160 m apart. */
std::vector<SphereQuestion> SphereQuestions(int count) {
  std::vector<SphereQuestion> questions;
  Random random(17);
  for (int k = 0; k < count; ++k) {
    SphereQuestion q{{random.Between(0.1, 2)}, {}, {random.Between(0.1, 2)}, {}};
    q.X_WA.p_WB = 5 * random.Direction();
    const double distance = k % 5 == 0 ? 1e-160 * random.Below(2) : random.Between(0, 4);
    if (k % 5 == 0) q.X_WA.p_WB *= 0;
    q.X_WB.p_WB = q.X_WA.p_WB + distance * random.Direction();
    questions.push_back(q);
  }
  return questions;
}

SphereBatch BatchOf(const std::vector<SphereQuestion>& questions) {
  SphereBatch batch(questions.size());
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const SphereQuestion& q = questions[k];
    batch.Set(k, q.A, q.X_WA, q.B, q.X_WB);
  }
  batch.FindGaps();
  return batch;
}

std::uint64_t Bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

using SphereBatchOnTarget = OnTarget;

TEST_P(SphereBatchOnTarget, ReturnsTheBitsOfOnePairAtATime) {
  // 1003: the last block is not full.
  const std::vector<SphereQuestion> questions = SphereQuestions(1003);
  const SphereBatch batch = BatchOf(questions);
  ASSERT_EQ(batch.separations().size(), questions.size());
  int touching = 0;
  for (std::size_t k = 0; k < questions.size() && !HasFailure(); ++k) {
    const SphereQuestion& q = questions[k];
    const Manifold manifold = Collide(q.A, q.X_WA, q.B, q.X_WB);
    touching += manifold.touching;
    EXPECT_EQ(Bits(batch.separations()[k]), Bits(manifold.separation));
    EXPECT_EQ(FindGap(q.A, q.X_WA, q.B, q.X_WB).n_AB_W, manifold.n_AB_W);
  }
  EXPECT_GT(touching, 300);
  EXPECT_LT(touching, 900);
}

INSTANTIATE_TEST_SUITE_P(Targets, SphereBatchOnTarget, testing::ValuesIn(Targets()),
                         NameOfTarget);

}  // namespace
}  // namespace cookbook::test
