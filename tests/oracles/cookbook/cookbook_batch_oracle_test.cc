#include "oracles/cookbook/cookbook_batch_oracle.h"

#include <vector>

#include <gtest/gtest.h>

#include "oracles/cookbook/cookbook_oracle.h"

namespace touchstone {
namespace {

std::vector<ContactQuery> BoxesAtManyDistances() {
  std::vector<ContactQuery> queries;
  for (int k = 0; k < 37; ++k) {
    const Pose X_WA = Pose::FromQuaternion(
        {0.3, -1.7, 2.1}, Eigen::Quaterniond(0.3, -0.4, 0.7, 0.1 * k).normalized());
    const Pose X_WB =
        Pose::FromQuaternion({0.3 + 0.07 * k, -1.4, 1.8},
                             Eigen::Quaterniond(-0.1, 0.5, 0.2 * k, 0.8).normalized());
    queries.push_back({{Box{{0.7, 0.4, 0.5}}, X_WA}, {Box{{0.3, 0.6, 0.2}}, X_WB}});
  }
  return queries;
}

TEST(CookbookBatchOracle, AgreesWithQueriesAnsweredOneByOne) {
  const std::vector<ContactQuery> queries = BoxesAtManyDistances();
  std::vector<ContactAnswer> batch(queries.size());
  std::vector<ContactAnswer> single(queries.size());
  const CookbookBatchOracle oracle;
  oracle.Answer(queries, batch);
  CookbookOracle().Answer(queries, single);
  int touching = 0;
  for (std::size_t k = 0; k < queries.size(); ++k) {
    ASSERT_EQ(batch[k].status, AnswerStatus::kAnswered);
    EXPECT_EQ(batch[k].touching, single[k].touching);
    EXPECT_EQ(batch[k].separation, single[k].separation);
    EXPECT_TRUE(batch[k].points.empty());
    if (!batch[k].touching) continue;
    ++touching;
    EXPECT_EQ(*batch[k].n_AB_W, *single[k].n_AB_W);
  }
  EXPECT_GT(touching, 5);
  EXPECT_LT(touching, 32);

  const std::unique_ptr<PreparedBatch> prepared = oracle.Prepare(queries);
  prepared->Run();
  ASSERT_EQ(prepared->separations().size(), queries.size());
  for (std::size_t k = 0; k < queries.size(); ++k) {
    EXPECT_EQ(prepared->separations()[k] <= 0, batch[k].touching);
  }
}

TEST(CookbookBatchOracle, MixedBatchesKeepTheOrderOfTheQueries) {
  std::vector<ContactQuery> queries = BoxesAtManyDistances();
  for (std::size_t k = 0; k < queries.size(); k += 2) {
    queries[k].A.shape = Sphere{0.7};
    queries[k].B.shape = Sphere{0.4};
  }
  std::vector<ContactAnswer> batch(queries.size());
  std::vector<ContactAnswer> single(queries.size());
  const CookbookBatchOracle oracle;
  oracle.Answer(queries, batch);
  CookbookOracle().Answer(queries, single);
  const std::unique_ptr<PreparedBatch> prepared = oracle.Prepare(queries);
  prepared->Run();
  for (std::size_t k = 0; k < queries.size(); ++k) {
    ASSERT_EQ(batch[k].status, AnswerStatus::kAnswered);
    EXPECT_EQ(batch[k].touching, single[k].touching);
    EXPECT_EQ(batch[k].separation, single[k].separation);
    EXPECT_EQ(prepared->separations()[k] <= 0, batch[k].touching);
    if (k % 2 == 0) {
      EXPECT_EQ(prepared->separations()[k], *single[k].separation);
      EXPECT_EQ(*batch[k].n_AB_W, *single[k].n_AB_W);
    }
  }
}

TEST(CookbookBatchOracle, SkipsPairsThatItDoesNotSupport) {
  std::vector<ContactQuery> queries = BoxesAtManyDistances();
  queries[3].B.shape = Sphere{0.4};
  std::vector<ContactAnswer> answers(queries.size());
  const CookbookBatchOracle oracle;
  oracle.Answer(queries, answers);
  EXPECT_EQ(answers[3].status, AnswerStatus::kUnsupported);
  EXPECT_EQ(answers[3].reason,
            oracle.info().For(ShapeKind::kBox, ShapeKind::kSphere).reason);
  EXPECT_EQ(answers[2].status, AnswerStatus::kAnswered);
  EXPECT_EQ(answers[4].status, AnswerStatus::kAnswered);
}

}  // namespace
}  // namespace touchstone
