// The engine against 113-bit arithmetic, on families of hard cases. Every bound is the
// one that engine/collision/rounding.h derives; none is fitted to the engine's results.

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "engine/collision/rounding.h"
#include "tests/engine/quad_boxes.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

constexpr int kQuestions = 1500;

QuadVector Widen(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

std::string Describe(const BoxQuestion& q) {
  const Eigen::IOFormat exact(Eigen::FullPrecision, 0, ", ", "; ", "", "", "[", "]");
  std::ostringstream out;
  out << "A: h " << q.A.half_extents.transpose().format(exact) << " R "
      << q.X_WA.R_WB.format(exact) << " p " << q.X_WA.p_WB.transpose().format(exact)
      << "\nB: h " << q.B.half_extents.transpose().format(exact) << " R "
      << q.X_WB.R_WB.format(exact) << " p " << q.X_WB.p_WB.transpose().format(exact);
  return out.str();
}

class BoxBoxAccuracy : public testing::TestWithParam<Family> {
 protected:
  /** Draws the family's questions and calls `check` with each and the engine's answer. */
  template <class Check>
  void Sweep(const Check& check) {
    Random random(20250131);
    int touching = 0;
    for (int k = 0; k < kQuestions && !HasFailure(); ++k) {
      const BoxQuestion q = GetParam().draw(random);
      const Manifold answer = Collide(q.A, q.X_WA, q.B, q.X_WB);
      touching += answer.touching;
      SCOPED_TRACE("question " + std::to_string(k) + "\n" + Describe(q));
      check(q, answer, PairSize(q.A, q.X_WA, q.B, q.X_WB));
    }
    EXPECT_GE(touching, kQuestions / 4) << "the sweep must touch something";
  }
};

TEST_P(BoxBoxAccuracy, VerdictAndDepthAreThoseOfTheTrueBoxes) {
  Sweep([&](const BoxQuestion& q, const Manifold& answer, double size) {
    const auto truth = static_cast<double>(GreatestGap({q.A, q.X_WA}, {q.B, q.X_WB}));
    const double bound = kDepthRounding * size;
    if (std::abs(truth) > bound) {
      EXPECT_EQ(answer.touching, truth < 0) << truth;
    }
    if (answer.touching && truth <= 0) {
      EXPECT_NEAR(answer.separation, truth, bound);
    }
  });
}

TEST_P(BoxBoxAccuracy, SeparationIsTheGapAlongItsOwnNormal) {
  Sweep([&](const BoxQuestion& q, const Manifold& answer, double size) {
    const auto overlap = static_cast<double>(
        OverlapAlong({q.A, q.X_WA}, {q.B, q.X_WB}, Widen(answer.n_AB_W)));
    EXPECT_NEAR(-answer.separation, overlap, kOverlapRounding * size);
    EXPECT_NEAR(answer.n_AB_W.norm(), 1, 16 * kUnitRoundoff);
  });
}

TEST_P(BoxBoxAccuracy, ContactsLieOnBothSurfaces) {
  Sweep([&](const BoxQuestion& q, const Manifold& answer, double size) {
    EXPECT_EQ(answer.touching, answer.count > 0);
    std::set<FeatureId> features;
    for (const ContactPoint& contact : answer.points()) {
      features.insert(contact.feature);
      EXPECT_GE(contact.separation, answer.separation);
      QuadVector on_A;
      QuadVector on_B;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const Quad half = static_cast<Quad>(answer.n_AB_W[i]) * contact.separation / 2;
        on_A[k] = contact.p_WC[i] - half;
        on_B[k] = contact.p_WC[i] + half;
      }
      const double place = contact.p_WC.lpNorm<Eigen::Infinity>();
      const double bound = kDepthRounding * size + 4 * kUnitRoundoff * place;
      const double error = std::max(DistanceFromSurface(q.A, q.X_WA, on_A),
                                    DistanceFromSurface(q.B, q.X_WB, on_B));
      EXPECT_LE(error, bound) << "contact " << contact.p_WC.transpose();
    }
    EXPECT_EQ(features.size(), static_cast<std::size_t>(answer.count));
  });
}

INSTANTIATE_TEST_SUITE_P(Families, BoxBoxAccuracy, testing::ValuesIn(Families()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace cookbook::test
