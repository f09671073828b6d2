#include "engine/dynamics/aabb_tree.h"

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
using Boxes = std::map<int, LooseBox>;

std::vector<int> OverlappingAnyOrder(const Boxes& boxes, const LooseBox& asked) {
  std::vector<int> found;
  for (const auto& [body, box] : boxes) {
    if (box.Overlaps(asked)) found.push_back(body);
  }
  return found;
}

RC_GTEST_PROP(AabbTree, FindsWhatOverlapsWhoeverCameAndWent, ()) {
  AabbTree tree;
  Boxes boxes;
  AabbTree::Room room;
  std::size_t hits = 0;
  // Up to a tree of three levels and down again.
  const int most = Draw(1, 400);
  for (int change = 0; change < 3 * most; ++change) {
    const int body = Draw(0, most);
    if (boxes.erase(body) > 0) tree.Remove(body);
    // The more likely the later, the more go.
    if (Draw(0, 3 * most) > change) {
      const LooseBox box = LooseBox::Around(SomeBox());
      boxes.emplace(body, box);
      tree.Insert(box, body);
    }
    if (change % 16 != 0) continue;
    const LooseBox asked = LooseBox::Around(SomeBox());
    const std::span<const int> answer = tree.Query(asked, room);
    std::vector<int> found(answer.begin(), answer.end());
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

TEST(AabbTree, IsEmptyBeforeTheFirstAndAfterTheLast) {
  AabbTree tree;
  AabbTree::Room room;
  const LooseBox box =
      LooseBox::Around({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()});
  EXPECT_TRUE(tree.Query(box, room).empty());
  for (int body = 0; body < 40; ++body) tree.Insert(box, body);
  EXPECT_EQ(tree.Query(box, room).size(), 40u);
  for (int body = 0; body < 40; ++body) tree.Remove(body);
  EXPECT_TRUE(tree.Query(box, room).empty());
  tree.Insert(box, 3);
  EXPECT_EQ(tree.Query(box, room).size(), 1u);
}

RC_GTEST_PROP(LooseBox, HoldsWhatItIsAroundAndLittleMore, ()) {
  const Aabb box = SomeBox();
  const LooseBox loose = LooseBox::Around(box);
  constexpr double kFar = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double low = std::max(box.low[i], -kFar);
    const double high = std::min(box.high[i], kFar);
    RC_ASSERT(loose.low[k] <= low);
    RC_ASSERT(loose.high[k] >= high);
    RC_ASSERT(loose.low[k] >= low - 3e-7 * std::abs(low) - 1e-30);
    RC_ASSERT(loose.high[k] <= high + 3e-7 * std::abs(high) + 1e-30);
  }
  RC_ASSERT(loose.Overlaps(loose));
  RC_ASSERT(!LooseBox::Nothing().Overlaps(loose));
  RC_ASSERT(!loose.Overlaps(LooseBox::Nothing()));
}

TEST(LooseBox, OfAllTheWorldOverlapsAllButNothing) {
  const Eigen::Vector3d far =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  const LooseBox world = LooseBox::Around({-far, far});
  EXPECT_TRUE(world.Overlaps(world));
  EXPECT_TRUE(world.Overlaps(LooseBox::Around(
      {Eigen::Vector3d::Constant(1e12), Eigen::Vector3d::Constant(1e12)})));
  EXPECT_FALSE(world.Overlaps(LooseBox::Nothing()));
}

}  // namespace
}  // namespace cookbook
