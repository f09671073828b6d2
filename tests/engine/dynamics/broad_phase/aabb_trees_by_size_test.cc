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

/** Returns a number in [low, high), any as likely, in the first cases as in the last. */
int Draw(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

double Uniform(double low, double high) {
  return low + (high - low) * Draw(0, 1 << 20) / (1 << 20);
}

/** From a grain to a wall, now and then the half of a world. */
Aabb SomeBox() {
  const Eigen::Vector3d middle(Uniform(-9, 9), Uniform(-9, 9), Uniform(-9, 9));
  const Eigen::Vector3d half =
      std::pow(10, Uniform(-2, 0.5)) * Eigen::Vector3d(Uniform(0, 1), Uniform(0, 1), 1);
  Aabb box{middle - half, middle + half};
  constexpr double kFar = std::numeric_limits<double>::max();
  if (Draw(0, 30) == 0) box.low.setConstant(-kFar);
  if (Draw(0, 30) == 0) box.high = Eigen::Vector3d(kFar, kFar, middle[2] + 1);
  return box;
}

/** The boxes of a tree, to be asked one by one. */
using Boxes = std::map<int, Aabb>;

std::vector<int> OverlappingAnyOrder(const Boxes& boxes, const Aabb& asked) {
  std::vector<int> found;
  for (const auto& [body, box] : boxes) {
    if (box.Overlaps(asked)) found.push_back(body);
  }
  return found;
}

/** Returns what a tree, or a forest, answers. */
std::vector<int> Answer(const AabbTree& tree, const Aabb& asked, AabbTree::Room& room) {
  room.found.clear();
  tree.Find(asked, room);
  return room.found;
}
std::vector<int> Answer(const AabbTreesBySize& forest, const Aabb& asked,
                        AabbTree::Room& room) {
  const std::span<const int> found = forest.Query(asked, room);
  return {found.begin(), found.end()};
}

/** Boxes that come and go, up to a tree of three levels and down again. */
template <class Tree>
void ExpectFindsWhatOverlaps() {
  Tree tree;
  Boxes boxes;
  AabbTree::Room room;
  std::size_t hits = 0;
  const int most = Draw(1, 400);
  for (int change = 0; change < 3 * most; ++change) {
    const int body = Draw(0, most);
    if (boxes.erase(body) > 0) tree.Remove(body);
    // The more likely the later, the more go.
    if (Draw(0, 3 * most) > change) {
      const Aabb box = SomeBox();
      boxes.emplace(body, box);
      tree.Insert(box, body);
    }
    if (change % 16 != 0) continue;
    const Aabb asked = SomeBox();
    std::vector<int> found = Answer(tree, asked, room);
    std::sort(found.begin(), found.end());
    RC_ASSERT(found == OverlappingAnyOrder(boxes, asked));
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

RC_GTEST_PROP(AabbTree, FindsWhatOverlapsWhoeverCameAndWent, ()) {
  ExpectFindsWhatOverlaps<AabbTree>();
}

RC_GTEST_PROP(AabbTreesBySize, FindsWhatOverlapsWhoeverCameAndWent, ()) {
  ExpectFindsWhatOverlaps<AabbTreesBySize>();
}

TEST(AabbTree, IsEmptyBeforeTheFirstAndAfterTheLast) {
  AabbTree tree;
  AabbTree::Room room;
  const Aabb box{Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
  EXPECT_TRUE(Answer(tree, box, room).empty());
  for (int body = 0; body < 40; ++body) tree.Insert(box, body);
  EXPECT_EQ(Answer(tree, box, room).size(), 40u);
  for (int body = 0; body < 40; ++body) tree.Remove(body);
  EXPECT_TRUE(Answer(tree, box, room).empty());
  tree.Insert(box, 3);
  EXPECT_EQ(Answer(tree, box, room).size(), 1u);
}

TEST(AabbTree, FindsWhatOnlyTouches) {
  AabbTree tree;
  AabbTree::Room room;
  tree.Insert({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d aside = Eigen::Vector3d::Unit(axis);
    EXPECT_EQ(Answer(tree, {aside, aside + Eigen::Vector3d::Ones()}, room).size(), 1u);
    EXPECT_EQ(Answer(tree, {-aside, Eigen::Vector3d::Ones() - aside}, room).size(), 1u);
  }
}

TEST(AabbTree, EndsWhereNoNumberDoes) {
  AabbTree tree;
  AabbTree::Room room;
  const Aabb world{-Aabb::Nothing().low, Aabb::Nothing().low};
  tree.Insert(world, 7);
  EXPECT_EQ(Answer(tree, world, room), std::vector<int>{7});
}

/** Boxes of 0.8 m at the places of a cube of 20 × 20 × 20 metres, in no order. */
std::vector<Aabb> Crowd() {
  std::vector<Aabb> crowd;
  for (int k = 0; k < 8000; ++k) {
    const int at = k * 4567 % 8000;
    const Eigen::Vector3d middle(at % 20, at / 20 % 20, at / 400);
    crowd.push_back({middle.array() - 0.4, middle.array() + 0.4});
  }
  return crowd;
}

/** Nodes that a question about one of them looks at, on the average. */
double LookedAt(const AabbTreesBySize& forest, const std::vector<Aabb>& crowd) {
  AabbTree::Room room;
  for (const Aabb& box : crowd) forest.Query(box, room);
  return static_cast<double>(room.looked_at) / static_cast<double>(crowd.size());
}

// Three levels of a tree of eight thousand are five nodes or more.
TEST(AabbTreesBySize, LooksAtFewNodes) {
  AabbTreesBySize forest;
  const std::vector<Aabb> crowd = Crowd();
  int body = 0;
  for (const Aabb& box : crowd) forest.Insert(box, body++);
  EXPECT_LT(LookedAt(forest, crowd), 8);
  // As few when all have moved.
  for (int k = 0; k < body; ++k) {
    forest.Remove(k);
    forest.Insert(crowd[static_cast<std::size_t>((k + 1) % body)], k);
  }
  EXPECT_LT(LookedAt(forest, crowd), 8);
}

TEST(AabbTreesBySize, LooksAtFewNodesInsideWallsAndAboveAFloorThatCameFirst) {
  AabbTreesBySize forest;
  const std::vector<Aabb> crowd = Crowd();
  int body = 0;
  const Aabb world{-Aabb::Nothing().low, Aabb::Nothing().low};
  forest.Insert(world, body++);
  for (const double half : {300.0, 1000.0, 1e6}) {
    const Eigen::Vector3d far = Eigen::Vector3d::Constant(half);
    forest.Insert({-far, far}, body++);
  }
  for (const Aabb& box : crowd) forest.Insert(box, body++);
  EXPECT_LT(LookedAt(forest, crowd), 8 + 4);
}

}  // namespace
}  // namespace cookbook
