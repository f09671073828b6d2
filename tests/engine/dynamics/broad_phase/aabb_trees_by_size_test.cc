#include "engine/dynamics/broad_phase/aabb_trees_by_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace cookbook {
namespace {

/** Returns a uniformly distributed number in [low, high), independent of the case size.
 */
int Draw(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

double Uniform(double low, double high) {
  return low + (high - low) * Draw(0, 1 << 20) / (1 << 20);
}

/** Returns a box between a grain and a wall in size, sometimes half of the world. */
Aabb RandomBox() {
  const Eigen::Vector3d middle(Uniform(-9, 9), Uniform(-9, 9), Uniform(-9, 9));
  const Eigen::Vector3d half =
      std::pow(10, Uniform(-2, 0.5)) * Eigen::Vector3d(Uniform(0, 1), Uniform(0, 1), 1);
  Aabb box{middle - half, middle + half};
  constexpr double kFar = std::numeric_limits<double>::max();
  if (Draw(0, 30) == 0) box.low.setConstant(-kFar);
  if (Draw(0, 30) == 0) box.high = Eigen::Vector3d(kFar, kFar, middle[2] + 1);
  return box;
}

/** The boxes of a tree, for the exhaustive search. */
using Boxes = std::map<int, Aabb>;

std::vector<int> FindOverlapsExhaustively(const Boxes& boxes, const Aabb& query) {
  std::vector<int> found;
  for (const auto& [body, box] : boxes) {
    if (box.Overlaps(query)) found.push_back(body);
  }
  return found;
}

std::vector<int> Query(const AabbTree& tree, const Aabb& query,
                       AabbTree::Scratch& scratch) {
  scratch.found.clear();
  tree.Query(query, scratch);
  return scratch.found;
}
std::vector<int> Query(const AabbTreesBySize& trees, const Aabb& query,
                       AabbTree::Scratch& scratch) {
  const std::span<const int> found = trees.Query(query, scratch);
  return {found.begin(), found.end()};
}

/** Inserts and removes boxes until the tree has up to three levels, then empties it. */
template <class Tree>
void ExpectFindsAllOverlaps() {
  Tree tree;
  Boxes boxes;
  AabbTree::Scratch scratch;
  std::size_t hits = 0;
  const int most = Draw(1, 400);
  for (int change = 0; change < 3 * most; ++change) {
    const int body = Draw(0, most);
    if (boxes.erase(body) > 0) tree.Remove(body);
    // Insertions become less likely with time.
    if (Draw(0, 3 * most) > change) {
      const Aabb box = RandomBox();
      boxes.emplace(body, box);
      tree.Insert(box, body);
    }
    if (change % 16 != 0) continue;
    const Aabb query = RandomBox();
    std::vector<int> found = Query(tree, query, scratch);
    std::sort(found.begin(), found.end());
    RC_ASSERT(found == FindOverlapsExhaustively(boxes, query));
    hits += found.size();
  }
  std::vector<int> all;
  tree.ForEach([&](int body) { all.push_back(body); });
  std::sort(all.begin(), all.end());
  std::vector<int> expected;
  for (const auto& [body, box] : boxes) expected.push_back(body);
  RC_ASSERT(all == expected);
  RC_CLASSIFY(hits > 0);
}

RC_GTEST_PROP(AabbTree, FindsAllOverlapsAfterAnyInsertionsAndRemovals, ()) {
  ExpectFindsAllOverlaps<AabbTree>();
}

RC_GTEST_PROP(AabbTreesBySize, FindsAllOverlapsAfterAnyInsertionsAndRemovals, ()) {
  ExpectFindsAllOverlaps<AabbTreesBySize>();
}

TEST(AabbTree, IsEmptyBeforeTheFirstInsertionAndAfterTheLastRemoval) {
  AabbTree tree;
  AabbTree::Scratch scratch;
  const Aabb box{Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
  EXPECT_TRUE(Query(tree, box, scratch).empty());
  for (int body = 0; body < 40; ++body) tree.Insert(box, body);
  EXPECT_EQ(Query(tree, box, scratch).size(), 40u);
  for (int body = 0; body < 40; ++body) tree.Remove(body);
  EXPECT_TRUE(Query(tree, box, scratch).empty());
  tree.Insert(box, 3);
  EXPECT_EQ(Query(tree, box, scratch).size(), 1u);
}

TEST(AabbTree, FindsBoxesThatOnlyTouch) {
  AabbTree tree;
  AabbTree::Scratch scratch;
  tree.Insert({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d aside = Eigen::Vector3d::Unit(axis);
    EXPECT_EQ(Query(tree, {aside, aside + Eigen::Vector3d::Ones()}, scratch).size(), 1u);
    EXPECT_EQ(Query(tree, {-aside, Eigen::Vector3d::Ones() - aside}, scratch).size(), 1u);
  }
}

TEST(AabbTree, FindsAnInfiniteBox) {
  AabbTree tree;
  AabbTree::Scratch scratch;
  const Aabb world{-Aabb::Empty().low, Aabb::Empty().low};
  tree.Insert(world, 7);
  EXPECT_EQ(Query(tree, world, scratch), std::vector<int>{7});
}

/** Boxes of 0.8 m on a grid of 20 × 20 × 20 m with a spacing of 1 m, in shuffled order.
 */
std::vector<Aabb> GridOfBoxes() {
  std::vector<Aabb> boxes;
  for (int k = 0; k < 8000; ++k) {
    const int at = k * 4567 % 8000;
    const Eigen::Vector3d middle(at % 20, at / 20 % 20, at / 400);
    boxes.push_back({middle.array() - 0.4, middle.array() + 0.4});
  }
  return boxes;
}

/** Returns the mean number of nodes that a query for one of the boxes visits. */
double MeanNodesVisited(const AabbTreesBySize& trees, const std::vector<Aabb>& boxes) {
  AabbTree::Scratch scratch;
  for (const Aabb& box : boxes) trees.Query(box, scratch);
  return static_cast<double>(scratch.nodes_visited) / static_cast<double>(boxes.size());
}

// A tree of eight thousand boxes has at least four levels, and a query visits about five
// nodes or more.
TEST(AabbTreesBySize, VisitsFewNodes) {
  AabbTreesBySize trees;
  const std::vector<Aabb> boxes = GridOfBoxes();
  int body = 0;
  for (const Aabb& box : boxes) trees.Insert(box, body++);
  EXPECT_LT(MeanNodesVisited(trees, boxes), 8);
  // The same after all boxes have moved.
  for (int k = 0; k < body; ++k) {
    trees.Remove(k);
    trees.Insert(boxes[static_cast<std::size_t>((k + 1) % body)], k);
  }
  EXPECT_LT(MeanNodesVisited(trees, boxes), 8);
}

TEST(AabbTreesBySize, VisitsFewNodesInsideWallsAndAboveAFloorThatWereAddedFirst) {
  AabbTreesBySize trees;
  const std::vector<Aabb> boxes = GridOfBoxes();
  int body = 0;
  const Aabb world{-Aabb::Empty().low, Aabb::Empty().low};
  trees.Insert(world, body++);
  for (const double half : {300.0, 1000.0, 1e6}) {
    const Eigen::Vector3d far = Eigen::Vector3d::Constant(half);
    trees.Insert({-far, far}, body++);
  }
  for (const Aabb& box : boxes) trees.Insert(box, body++);
  EXPECT_LT(MeanNodesVisited(trees, boxes), 8 + 4);
}

}  // namespace
}  // namespace cookbook
