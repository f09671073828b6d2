#include "engine/dynamics/solver/block_cholesky.h"

#include <algorithm>
#include <iterator>

#include <Eigen/Cholesky>

namespace cookbook {

void BlockCholesky::Analyze(int nodes, std::span<const Edge> edges) {
  if (neighbours_.size() < At(nodes)) neighbours_.resize(At(nodes));
  for (std::size_t i = 0; i < At(nodes); ++i) neighbours_[i].clear();
  for (const auto& [a, b] : edges) {
    neighbours_[At(a)].push_back(b);
    neighbours_[At(b)].push_back(a);
  }
  for (std::size_t i = 0; i < At(nodes); ++i) {
    std::vector<int>& list = neighbours_[i];
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  positions_.assign(At(nodes), -1);
  Eliminate();
  diagonal_.resize(At(nodes));
  off_diagonal_.resize(rows_.size());

  edge_blocks_.clear();
  for (const auto& [a, b] : edges) {
    const int row = positions_[At(a)];
    const int column = positions_[At(b)];
    edge_blocks_.push_back(
        {FindBlock(std::max(row, column), std::min(row, column)), row < column});
  }
  targets_.clear();
  for (std::size_t c = 0; c < At(nodes); ++c) {
    for (std::size_t i = starts_[c]; i < starts_[c + 1]; ++i) {
      for (std::size_t j = starts_[c]; j < i; ++j)
        targets_.push_back(FindBlock(rows_[i], rows_[j]));
    }
  }
}

void BlockCholesky::Eliminate() {
  order_.clear();
  rows_.clear();
  starts_.assign(1, 0);
  for (std::size_t done = 0; done < positions_.size(); ++done) {
    int next = -1;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (positions_[i] >= 0) continue;
      if (next < 0 || neighbours_[i].size() < neighbours_[At(next)].size())
        next = static_cast<int>(i);
    }
    positions_[At(next)] = static_cast<int>(done);
    order_.push_back(next);
    // Its neighbours are those that are left, and become neighbours of each other.
    const std::vector<int>& list = neighbours_[At(next)];
    for (const int one : list) {
      std::vector<int>& others = neighbours_[At(one)];
      merged_.clear();
      std::set_union(others.begin(), others.end(), list.begin(), list.end(),
                     std::back_inserter(merged_));
      std::erase_if(merged_, [&](int node) { return node == one || node == next; });
      others.assign(merged_.begin(), merged_.end());
    }
    rows_.insert(rows_.end(), list.begin(), list.end());
    starts_.push_back(rows_.size());
  }
  // Positions instead of nodes.
  for (std::size_t c = 0; c < order_.size(); ++c) {
    const std::span<int> rows =
        std::span(rows_).subspan(starts_[c], starts_[c + 1] - starts_[c]);
    for (int& row : rows) row = positions_[At(row)];
    std::sort(rows.begin(), rows.end());
  }
}

std::size_t BlockCholesky::FindBlock(int row, int column) const {
  const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(starts_[At(column)]);
  const auto last = rows_.begin() + static_cast<std::ptrdiff_t>(starts_[At(column) + 1]);
  return static_cast<std::size_t>(std::lower_bound(first, last, row) - rows_.begin());
}

void BlockCholesky::SetZero() {
  for (Block& block : diagonal_) block.setZero();
  for (Block& block : off_diagonal_) block.setZero();
}

void BlockCholesky::AddOffDiagonal(std::size_t edge, const Block& block) {
  const auto& [index, is_transposed] = edge_blocks_[edge];
  if (is_transposed) {
    off_diagonal_[index] += block.transpose();
  } else {
    off_diagonal_[index] += block;
  }
}

bool BlockCholesky::Factor() {
  std::size_t target = 0;
  for (std::size_t c = 0; c < diagonal_.size(); ++c) {
    const Eigen::LLT<Block> factor(diagonal_[c]);
    if (factor.info() != Eigen::Success) return false;
    diagonal_[c] = factor.matrixL();
    for (std::size_t i = starts_[c]; i < starts_[c + 1]; ++i) {
      Block& block = off_diagonal_[i];
      diagonal_[c]
          .triangularView<Eigen::Lower>()
          .transpose()
          .solveInPlace<Eigen::OnTheRight>(block);
      for (std::size_t j = starts_[c]; j < i; ++j)
        off_diagonal_[targets_[target++]].noalias() -=
            block * off_diagonal_[j].transpose();
      diagonal_[At(rows_[i])].noalias() -= block * block.transpose();
    }
  }
  return true;
}

void BlockCholesky::Solve(std::span<Vector> x) const {
  for (std::size_t c = 0; c < diagonal_.size(); ++c) {
    Vector& own = x[At(order_[c])];
    diagonal_[c].triangularView<Eigen::Lower>().solveInPlace(own);
    for (std::size_t i = starts_[c]; i < starts_[c + 1]; ++i)
      x[At(order_[At(rows_[i])])].noalias() -= off_diagonal_[i] * own;
  }
  for (std::size_t c = diagonal_.size(); c-- > 0;) {
    Vector& own = x[At(order_[c])];
    for (std::size_t i = starts_[c]; i < starts_[c + 1]; ++i)
      own.noalias() -= off_diagonal_[i].transpose() * x[At(order_[At(rows_[i])])];
    diagonal_[c].triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
}

}  // namespace cookbook
