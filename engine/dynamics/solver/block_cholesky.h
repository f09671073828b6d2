#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace cookbook {

/** A sparse Cholesky factorization A = L Lᵀ of a symmetric positive definite matrix of
 6 × 6 blocks: one row and column for each node of a graph, one block for each edge.

 Nodes are eliminated by minimum degree (Tinney & Walker, Proc. IEEE 55, 1967), ties by
 their index. A tree loses its leaves one after the other and gets no fill, so that its
 factorization takes linear time. Nothing is allocated once the vectors are large enough,
 and the result has the same bits whenever the arguments have. */
class BlockCholesky {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;
  using Vector = Eigen::Matrix<double, 6, 1>;
  using Edge = std::array<int, 2>;  ///< Two different nodes.

  /** Finds the order of elimination and the structure of L for the nodes 0, 1, …,
   `nodes` − 1. Two edges may connect the same nodes. */
  void Analyze(int nodes, std::span<const Edge> edges);

  /** Sets the matrix to zero. */
  void SetZero();
  /** The block of a node, of which the lower triangle is used. */
  Block& Diagonal(int node) { return diagonal_[At(positions_[At(node)])]; }
  /** Adds `block` at the row of the first node of `edge` and the column of the second,
   and its transpose at the mirrored place. */
  void AddOffDiagonal(std::size_t edge, const Block& block);

  /** Factors the matrix in place. Returns false if it is not positive definite. */
  [[nodiscard]] bool Factor();
  /** Solves A x = b in place. `x` is indexed by node.
   @pre Factor() has returned true. */
  void Solve(std::span<Vector> x) const;

 private:
  /** The block of an edge in off_diagonal_. */
  struct EdgeBlock {
    std::size_t block;
    bool is_transposed;
  };

  static std::size_t At(int index) { return static_cast<std::size_t>(index); }
  /** Eliminates all nodes: fills order_, positions_, starts_ and rows_. */
  void Eliminate();
  /** Returns the index in off_diagonal_ of the block at this row and column. */
  std::size_t FindBlock(int row, int column) const;

  std::vector<std::vector<int>> neighbours_;  ///< Sorted; scratch of Analyze().
  std::vector<int> merged_;                   ///< Scratch of Analyze().
  std::vector<int> order_;                    ///< Node by position in the elimination.
  std::vector<int> positions_;                ///< The inverse of order_.
  /** Column c of L has the blocks starts_[c] to starts_[c + 1] below its diagonal. */
  std::vector<std::size_t> starts_;
  std::vector<int> rows_;               ///< Their rows, as positions, ascending.
  std::vector<std::size_t> targets_;    ///< Blocks that the update of a column changes.
  std::vector<EdgeBlock> edge_blocks_;  ///< Indexed by edge.
  std::vector<Block> diagonal_;         ///< Indexed by position.
  std::vector<Block> off_diagonal_;     ///< Indexed like rows_.
};

}  // namespace cookbook
