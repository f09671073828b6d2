#include "oracles/cookbook/cookbook_oracle.h"

#include <vector>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

const Pose kPoseA = Pose::FromQuaternion(
    {0.3, -1.7, 2.1}, Eigen::Quaterniond(0.3, -0.4, 0.7, 0.2).normalized());
const Pose kPoseB = Pose::FromQuaternion(
    {0.9, -1.4, 1.8}, Eigen::Quaterniond(-0.1, 0.5, 0.2, 0.8).normalized());

ContactQuery Ask(const Shape& a, const Shape& b) {
  return {{a, kPoseA}, {b, kPoseB}};
}

TEST(CookbookOracle, AnswersSpheresAndBoxesAndNothingElse) {
  const CookbookOracle oracle;
  const std::vector<Shape> shapes = {Sphere{0.6},       Box{{0.7, 0.4, 0.5}},
                                     Capsule{0.3, 0.5}, Cylinder{0.3, 0.5},
                                     Cone{0.3, 0.5},    ConvexHull{{{0.1, 0.2, 0.3}}},
                                     HalfSpace{}};
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      const bool known = a.index() < 2 && b.index() < 2;
      const ContactAnswer answer = oracle.Answer(Ask(a, b));
      const Capability& capability = oracle.info().For(KindOf(a), KindOf(b));
      EXPECT_EQ(capability.supported, known);
      EXPECT_EQ(capability.reason.empty(), known);
      EXPECT_EQ(answer.status,
                known ? AnswerStatus::kAnswered : AnswerStatus::kUnsupported);
      EXPECT_EQ(answer.reason, capability.reason);
    }
  }
}

TEST(CookbookOracle, ReturnsNormalDepthAndContacts) {
  const CookbookOracle oracle;
  const ContactAnswer answer = oracle.Answer(Ask(Sphere{0.6}, Sphere{0.3}));
  // The centres are d = (0.6, 0.3, −0.3) apart: |d| = √0.54.
  const Eigen::Vector3d d(0.6, 0.3, -0.3);
  ASSERT_TRUE(answer.touching);
  EXPECT_NEAR(*answer.separation, d.norm() - 0.9, 1e-15);
  EXPECT_LT((*answer.n_AB_W - d.normalized()).norm(), 1e-15);
  ASSERT_EQ(answer.points.size(), 1u);
  EXPECT_EQ(answer.points[0].separation, *answer.separation);
  EXPECT_FALSE(answer.points[0].n_AB_W.has_value());
}

TEST(CookbookOracle, LeavesOutTheDistanceOfBoxesApart) {
  const CookbookOracle oracle;
  const Box small{{0.05, 0.07, 0.06}};
  const ContactAnswer boxes = oracle.Answer(Ask(small, small));
  EXPECT_FALSE(boxes.touching);
  EXPECT_FALSE(boxes.separation.has_value());
  EXPECT_TRUE(boxes.n_AB_W.has_value());
  EXPECT_TRUE(boxes.points.empty());
  EXPECT_TRUE(oracle.Answer(Ask(small, Sphere{0.05})).separation.has_value());
}

TEST(CookbookOracle, PreparedBatchReturnsTheSeparationsOfTheAnswers) {
  const CookbookOracle oracle;
  const std::vector<Shape> shapes = {Sphere{0.6}, Box{{0.7, 0.4, 0.5}}};
  std::vector<ContactQuery> queries;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) queries.push_back(Ask(a, b));
  }
  const std::unique_ptr<PreparedBatch> batch = oracle.Prepare(queries);
  ASSERT_NE(batch, nullptr);
  batch->Run();
  ASSERT_EQ(batch->separations().size(), queries.size());
  for (std::size_t k = 0; k < queries.size(); ++k) {
    EXPECT_EQ(batch->separations()[k], *oracle.Answer(queries[k]).separation);
  }
}

}  // namespace
}  // namespace touchstone
