#include "engine/dynamics/solver/block_cholesky.h"

#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "tests/engine/dynamics/random.h"

namespace cookbook {
namespace {

using Block = BlockCholesky::Block;
using Vector = BlockCholesky::Vector;

Block RandomBlock(Random& random) {
  return Block::NullaryExpr([&] { return random.Uniform(-1, 1); });
}

/** Fills `solver` and returns the same matrix dense. It is positive definite, because its
 diagonal dominates. */
Eigen::MatrixXd Fill(int nodes, const std::vector<BlockCholesky::Edge>& edges,
                     Random& random, BlockCholesky& solver) {
  solver.Analyze(nodes, edges);
  solver.SetZero();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * nodes, 6 * nodes);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto& [a, b] = edges[k];
    const Block block = RandomBlock(random);
    solver.AddOffDiagonal(k, block);
    dense.block<6, 6>(6 * a, 6 * b) += block;
    dense.block<6, 6>(6 * b, 6 * a) += block.transpose();
  }
  for (int i = 0; i < nodes; ++i) {
    const Block block = RandomBlock(random);
    const Block diagonal =
        block * block.transpose() +
        6.0 * (1.0 + static_cast<double>(edges.size())) * Block::Identity();
    solver.Diagonal(i) = diagonal;
    dense.block<6, 6>(6 * i, 6 * i) = diagonal;
  }
  return dense;
}

// Graphs with cycles, double edges, and nodes without edges.
TEST(BlockCholesky, SolvesLikeADenseFactorization) {
  Random random(1);
  BlockCholesky solver;
  for (int trial = 0; trial < 100; ++trial) {
    const int nodes = 1 + trial % 12;
    std::vector<BlockCholesky::Edge> edges;
    for (int k = 0; nodes > 1 && k < trial % 17; ++k) {
      const int a = random.Below(nodes);
      const int other = random.Below(nodes - 1);
      edges.push_back({a, other < a ? other : other + 1});
    }
    const Eigen::MatrixXd dense = Fill(nodes, edges, random, solver);
    ASSERT_TRUE(solver.Factor());
    Eigen::VectorXd right(6 * nodes);
    std::vector<Vector> x(static_cast<std::size_t>(nodes));
    for (int i = 0; i < nodes; ++i) {
      Vector& part = x[static_cast<std::size_t>(i)];
      part = Vector::NullaryExpr([&] { return random.Uniform(-1, 1); });
      right.segment<6>(6 * i) = part;
    }
    solver.Solve(x);
    const Eigen::VectorXd expected = dense.llt().solve(right);
    for (int i = 0; i < nodes; ++i) {
      // Some roundings: the matrix is well conditioned.
      EXPECT_LT((x[static_cast<std::size_t>(i)] - expected.segment<6>(6 * i)).norm(),
                1e-14)
          << trial;
    }
  }
}

TEST(BlockCholesky, ReportsAMatrixThatIsNotPositiveDefinite) {
  Random random(2);
  BlockCholesky solver;
  Fill(3, {{0, 1}, {1, 2}}, random, solver);
  solver.Diagonal(1).setZero();
  EXPECT_FALSE(solver.Factor());
}

}  // namespace
}  // namespace cookbook
