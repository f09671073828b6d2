// The published recipes of contact. Corrected, they agree with the engine; with their
// errata, they reproduce the known figures.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "engine/collision/rounding.h"
#include "engine/printed/collide.h"
#include "tests/engine/quad_boxes.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

using printed::Errata;
using printed::Erratum;

constexpr int kQuestions = 3000;

/** The error of 64 roundings of coordinates and sizes below 16 m. [m] */
constexpr double kRounding = 64 * 16 * kUnitRoundoff;

Pose At(double x, double y, double z) {
  return {Turn(Eigen::Vector3d(2, -1, 2) / 3, 0.7), {x, y, z}};
}

/** Returns the pose of B with A's orientation and its centre at `p_AB_A` in A's frame. */
Pose Beside(const Pose& X_WA, const Eigen::Vector3d& p_AB_A) {
  return {X_WA.R_WB, X_WA.p_WB + X_WA.R_WB * p_AB_A};
}

/** Returns the largest distance from one of `points` to the nearest of `others`. */
double Beyond(const std::vector<Eigen::Vector3d>& points,
              const std::vector<Eigen::Vector3d>& others) {
  double beyond = 0;
  for (const Eigen::Vector3d& point : points) {
    double nearest = 1e300;
    for (const Eigen::Vector3d& other : others) {
      nearest = std::min(nearest, (point - other).norm());
    }
    beyond = std::max(beyond, nearest);
  }
  return beyond;
}

TEST(PrintedWithoutErrata, SpheresAgreeWithTheEngine) {
  Random random(1);
  for (int k = 0; k < kQuestions; ++k) {
    const Sphere A{random.Between(0.1, 2)};
    const Sphere B{random.Between(0.1, 2)};
    const Pose X_WA{random.Rotation(), 3 * random.Direction()};
    const Pose X_WB{random.Rotation(),
                    X_WA.p_WB + random.Between(0, 4) * random.Direction()};
    const Manifold engine = Collide(A, X_WA, B, X_WB);
    const printed::Manifold recipe = printed::Collide(A, X_WA, B, X_WB, Errata::None());
    ASSERT_EQ(recipe.touching, engine.touching);
    if (!engine.touching) continue;
    EXPECT_NEAR(recipe.depth, -engine.separation, kRounding);
    EXPECT_LT((recipe.n_AB_W - engine.n_AB_W).norm(), kRounding);
    ASSERT_EQ(recipe.contacts_W.size(), 1u);
    EXPECT_LT((recipe.contacts_W[0] - engine.contacts[0].p_WC).norm(), kRounding);
  }
}

TEST(PrintedWithoutErrata, SpheresOnBoxesAgreeWithTheEngine) {
  Random random(2);
  int inside = 0;
  for (int k = 0; k < kQuestions; ++k) {
    const BoxQuestion q = AnyBoxes(random);
    const Sphere B{random.Between(0.1, 2)};
    const Manifold engine = Collide(q.A, q.X_WA, B, q.X_WB);
    const printed::Manifold recipe =
        printed::Collide(q.A, q.X_WA, B, q.X_WB, Errata::None());
    ASSERT_EQ(recipe.touching, engine.touching);
    if (!engine.touching) continue;
    inside += engine.separation < -B.radius;
    EXPECT_NEAR(recipe.depth, -engine.separation, kRounding);
    EXPECT_LT((recipe.n_AB_W - engine.n_AB_W).norm(), kRounding);
    ASSERT_EQ(recipe.contacts_W.size(), 1u);
    EXPECT_LT((recipe.contacts_W[0] - engine.contacts[0].p_WC).norm(), kRounding);

    const printed::Manifold swapped =
        printed::Collide(B, q.X_WB, q.A, q.X_WA, Errata::None());
    EXPECT_EQ(swapped.n_AB_W, -recipe.n_AB_W);
  }
  EXPECT_GT(inside, 100);
}

TEST(PrintedWithoutErrata, BoxesAgreeWithTheEngine) {
  Random random(3);
  int touching = 0;
  for (int k = 0; k < kQuestions && !HasFailure(); ++k) {
    const BoxQuestion q = AnyBoxes(random);
    const Manifold engine = Collide(q.A, q.X_WA, q.B, q.X_WB);
    const printed::Manifold recipe =
        printed::Collide(q.A, q.X_WA, q.B, q.X_WB, Errata::None());
    ASSERT_EQ(recipe.touching, engine.touching);
    if (!engine.touching) continue;
    ++touching;
    EXPECT_NEAR(recipe.depth, -engine.separation, kRounding);
    // Random poses: no two axes tie, and the deepest contact is a single point.
    EXPECT_LT((recipe.n_AB_W - engine.n_AB_W).norm(), 1e-12);
    std::vector<Eigen::Vector3d> deepest;
    for (const ContactPoint& contact : engine.points()) {
      if (contact.separation <= engine.separation + kRounding) {
        deepest.push_back(contact.p_WC);
      }
    }
    ASSERT_EQ(deepest.size(), 1u);
    // Clipping reaches some 1e-14 m beyond a face, which is 1e-14 / s along an edge of
    // slope s.
    EXPECT_LT(Beyond(deepest, recipe.contacts_W), 1e-9);
    EXPECT_LT(Beyond(recipe.contacts_W, deepest), 1e-9);
  }
  EXPECT_GT(touching, kQuestions / 2);
}

TEST(PrintedWithoutErrata, FlatBoxesShareTheWholePatchWithTheEngine) {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    const Box A{{1.1, 0.3, 0.9}};
    const Box B{{0.6, 0.25, 0.8}};
    const Pose X_WA{random.Rotation(), 2 * random.Direction()};
    Pose X_WB = Beside(X_WA, {random.Between(-1, 1), 0.54, random.Between(-1, 1)});
    X_WB.R_WB = X_WA.R_WB * Turn(Eigen::Vector3d::UnitY(), random.Between(0.1, 1.4));
    const Manifold engine = Collide(A, X_WA, B, X_WB);
    const printed::Manifold recipe = printed::Collide(A, X_WA, B, X_WB, Errata::None());
    ASSERT_TRUE(engine.touching);
    EXPECT_NEAR(recipe.depth, -engine.separation, kRounding);
    std::vector<Eigen::Vector3d> contacts;
    for (const ContactPoint& contact : engine.points()) contacts.push_back(contact.p_WC);
    // Clipping with a tolerance of 1e-13 S displaces a corner by that tolerance over the
    // sine of the turn.
    EXPECT_LT(Beyond(contacts, recipe.contacts_W), 1e-10);
    EXPECT_LT(Beyond(recipe.contacts_W, contacts), 1e-10);
  }
}

TEST(PrintedErrata, E01AndE02ReportBoxesApartAsTouching) {
  Random random(5);
  int apart = 0;
  int wrong = 0;
  for (int k = 0; k < kQuestions; ++k) {
    const BoxQuestion q = AnyBoxes(random);
    if (Collide(q.A, q.X_WA, q.B, q.X_WB).touching) continue;
    ++apart;
    wrong += printed::Collide(q.A, q.X_WA, q.B, q.X_WB, {Erratum::kE01, Erratum::kE02})
                 .touching;
  }
  // Known figure of the published recipe: 19,828 of 41,744, for another distribution of
  // poses.
  EXPECT_GT(wrong, 0.2 * apart);
  EXPECT_LT(wrong, 0.8 * apart);
}

TEST(PrintedErrata, E01MissesThePlaneBetweenTwoEdges) {
  // Two long bars, crossed edge on edge, 0.01 m apart along the cross product of the
  // edges.
  const Box bar{{3, 0.3, 0.4}};
  const Pose X_WA = At(0.4, -0.3, 1.2);
  const Eigen::Matrix3d on_edge = Turn(Eigen::Vector3d::UnitX(), 0.7);
  const double reach = 0.3 * std::cos(0.7) + 0.4 * std::sin(0.7);
  const Pose X_WS{X_WA.R_WB * on_edge, X_WA.p_WB};
  const Pose X_WB{X_WA.R_WB * Turn(Eigen::Vector3d::UnitY(), 1.1) * on_edge,
                  X_WA.p_WB + X_WA.R_WB.col(1) * (2 * reach + 0.01)};
  EXPECT_FALSE(printed::Collide(bar, X_WS, bar, X_WB, Errata::None()).touching);
  EXPECT_TRUE(printed::Collide(bar, X_WS, bar, X_WB, {Erratum::kE01}).touching);
}

TEST(PrintedErrata, E02TurnsMostNormalsOfBoxes) {
  Random random(6);
  int touching = 0;
  int turned = 0;
  for (int k = 0; k < kQuestions; ++k) {
    const BoxQuestion q = AnyBoxes(random);
    const Manifold engine = Collide(q.A, q.X_WA, q.B, q.X_WB);
    if (!engine.touching) continue;
    const printed::Manifold recipe =
        printed::Collide(q.A, q.X_WA, q.B, q.X_WB, Errata::All());
    ++touching;
    turned += recipe.n_AB_W.dot(engine.n_AB_W) < std::cos(8 * std::numbers::pi / 180);
  }
  // Known figure of the published recipe: 48,665 of 58,256 are off by more than 8°.
  EXPECT_GT(turned, 0.7 * touching);
}

TEST(PrintedErrata, E03TakesSphereDepthFromTheNormalisedDistance) {
  const Sphere unit{1};
  const Pose X_WA = At(0.1, 0.2, 0.3);
  const Pose X_WB = Beside(X_WA, {0, 0, 1.9});
  EXPECT_NEAR(printed::Collide(unit, X_WA, unit, X_WB, Errata::All()).depth, 0.5,
              kRounding);
  EXPECT_NEAR(printed::Collide(unit, X_WA, unit, X_WB, {Erratum::kE03}).depth, 1,
              kRounding);
  EXPECT_NEAR(printed::Collide(unit, X_WA, unit, X_WB, {}).depth, 0.1, kRounding);
}

TEST(PrintedErrata, E04HalvesTheDepthsOfSpheres) {
  const Pose X_WA = At(0.1, 0.2, 0.3);
  const Errata halved{Erratum::kE04};
  EXPECT_NEAR(
      printed::Collide(Sphere{1}, X_WA, Sphere{1}, Beside(X_WA, {0, 1.9, 0}), halved)
          .depth,
      0.05, kRounding);
  EXPECT_NEAR(printed::Collide(Box{{0.5, 0.6, 0.7}}, X_WA, Sphere{0.3},
                               Beside(X_WA, {0, 0, 0.9}), halved)
                  .depth,
              0.05, kRounding);
}

TEST(PrintedErrata, E05PushesASphereInABoxByItsRadiusFromCentreToCentre) {
  const Box A{{1, 1, 1}};
  const Pose X_WA = At(-0.7, 0.2, 0.3);
  const Pose X_WB = Beside(X_WA, {0.5, 0.2, 0.1});
  const Sphere B{0.25};
  EXPECT_NEAR(printed::Collide(A, X_WA, B, X_WB, Errata::All()).depth, 0.125, kRounding);
  EXPECT_NEAR(printed::Collide(A, X_WA, B, X_WB, {}).depth, 0.75, kRounding);
  const printed::Manifold alone = printed::Collide(A, X_WA, B, X_WB, {Erratum::kE05});
  EXPECT_NEAR(alone.depth, 0.25, kRounding);
  const Eigen::Vector3d centres = (X_WB.p_WB - X_WA.p_WB).normalized();
  EXPECT_LT((alone.n_AB_W - centres).norm(), kRounding);
}

TEST(PrintedErrata, E06ReportsNoCollisionForCoincidingCentres) {
  const Pose X_W = At(-0.7, 0.2, 0.3);
  const Errata faulty{Erratum::kE06};
  EXPECT_FALSE(printed::Collide(Sphere{1}, X_W, Sphere{2}, X_W, faulty).touching);
  EXPECT_FALSE(printed::Collide(Box{{1, 2, 3}}, X_W, Sphere{2}, X_W, faulty).touching);
  EXPECT_TRUE(printed::Collide(Sphere{1}, X_W, Sphere{2}, X_W, {}).touching);
  EXPECT_TRUE(printed::Collide(Box{{1, 2, 3}}, X_W, Sphere{2}, X_W, {}).touching);
}

TEST(PrintedErrata, E07LeavesAContainedBoxWithoutContact) {
  const Pose X_WA = At(-0.7, 0.2, 0.3);
  const Pose X_WB = Beside(X_WA, {0.3, 0.2, 0.1});
  const Box outer{{1, 1, 1}};
  const Box inner{{0.2, 0.1, 0.3}};
  EXPECT_TRUE(
      printed::Collide(outer, X_WA, inner, X_WB, {Erratum::kE07}).contacts_W.empty());
  EXPECT_TRUE(
      printed::Collide(outer, X_WA, inner, X_WB, Errata::All()).contacts_W.empty());
  EXPECT_EQ(printed::Collide(outer, X_WA, inner, X_WB, {}).contacts_W.size(), 4u);
  EXPECT_FALSE(
      printed::Collide(outer, X_WA, inner, X_WB, {Erratum::kE08}).contacts_W.empty());

  Random random(7);
  int touching = 0;
  int without = 0;
  for (int k = 0; k < kQuestions; ++k) {
    const BoxQuestion q = AnyBoxes(random);
    const printed::Manifold recipe =
        printed::Collide(q.A, q.X_WA, q.B, q.X_WB, {Erratum::kE07});
    touching += recipe.touching;
    without += recipe.touching && recipe.contacts_W.empty();
  }
  // Known figure of the published recipe: 1,032 of 58,256 random overlaps.
  EXPECT_GT(without, 0.002 * touching);
  EXPECT_LT(without, 0.1 * touching);
}

TEST(PrintedErrata, E08GivesAnEdgeOnAFaceFourContacts) {
  const Box floor{{1.1, 0.3, 0.9}};
  const Box B{{0.2, 0.25, 0.3}};
  const Pose X_WA = At(0.3, 0.8, -0.4);
  const double lowest = 0.2 * std::sin(0.6) + 0.25 * std::cos(0.6);
  Pose X_WB = Beside(X_WA, {0.1, 0.3 + lowest - 0.02, -0.2});
  X_WB.R_WB = X_WA.R_WB * Turn(Eigen::Vector3d::UnitZ(), 0.6);
  EXPECT_EQ(printed::Collide(floor, X_WA, B, X_WB, {Erratum::kE08}).contacts_W.size(),
            4u);
  EXPECT_EQ(printed::Collide(floor, X_WA, B, X_WB, {}).contacts_W.size(), 2u);
}

TEST(PrintedErrata, E09MergesTheContactsOfSmallBoxes) {
  const Box A{{0.011, 0.003, 0.009}};
  const Box B{{0.003, 0.002, 0.0035}};
  const Pose X_WA = At(0.3, 0.8, -0.4);
  const Pose X_WB = Beside(X_WA, {0.001, 0.0049, -0.002});
  EXPECT_EQ(printed::Collide(A, X_WA, B, X_WB, {}).contacts_W.size(), 4u);
  EXPECT_EQ(printed::Collide(A, X_WA, B, X_WB, {Erratum::kE09}).contacts_W.size(), 1u);
}

TEST(PrintedErrata, E26MeasuresTheCommonLengthOfTheIntervals) {
  // Half size 0.2 in 1.0, 0.2 off centre: the intervals have 0.4 in common, but the
  // shortest translation out is 1.
  const Pose X_WA = At(0.3, 0.8, -0.4);
  const Pose X_WB = Beside(X_WA, {0.2, 0.05, -0.02});
  const Box outer{{1, 1, 1}};
  const Box inner{{0.2, 0.2, 0.2}};
  EXPECT_NEAR(printed::Collide(outer, X_WA, inner, X_WB, {Erratum::kE26}).depth, 0.4,
              kRounding);
  EXPECT_NEAR(printed::Collide(outer, X_WA, inner, X_WB, {}).depth, 1.0, kRounding);
}

TEST(PrintedErrata, E27LosesContactsOfFlushBoxesToRounding) {
  // The same box twice, side by side and pressed together: four edges lie flush.
  const Box box{{0.7, 0.3, 0.4}};
  Random random(8);
  int lost = 0;
  for (int k = 0; k < 100; ++k) {
    const Pose X_WA{random.Rotation(), 2 * random.Direction()};
    const Pose X_WB = Beside(X_WA, {0, 0.59, 0});
    ASSERT_EQ(printed::Collide(box, X_WA, box, X_WB, {}).contacts_W.size(), 4u);
    lost += printed::Collide(box, X_WA, box, X_WB, {Erratum::kE27}).contacts_W.size() < 4;
  }
  EXPECT_GT(lost, 50);
}

TEST(PrintedErrata, E28TakesTouchingBoxesForApart) {
  const Box box{{0.5, 0.5, 0.5}};
  const Pose X_WA{Eigen::Matrix3d::Identity(), {0, 0, 0}};
  const Pose X_WB{Eigen::Matrix3d::Identity(), {1, 0.25, 0}};
  EXPECT_TRUE(printed::Collide(box, X_WA, box, X_WB, {}).touching);
  EXPECT_FALSE(printed::Collide(box, X_WA, box, X_WB, {Erratum::kE28}).touching);
}

TEST(PrintedErrata, E29MissesThePlaneBetweenNearlyParallelEdges) {
  // Two long bars at one degree, edge above edge: sin² 1° is 3e-4. The planes of their
  // faces leave no gap, because each bar rises over its length beside the other.
  const Box bar{{0.3, 0.4, 9}};
  const Pose X_WA = At(0.4, -0.3, 1.2);
  const Eigen::Matrix3d on_edge = Turn(Eigen::Vector3d::UnitZ(), 0.7);
  const double reach = 0.3 * std::sin(0.7) + 0.4 * std::cos(0.7);
  const Pose X_WS{X_WA.R_WB * on_edge, X_WA.p_WB};
  const Pose X_WB{X_WA.R_WB * Turn(Eigen::Vector3d::UnitY(), 0.0175) * on_edge,
                  X_WA.p_WB + X_WA.R_WB.col(1) * (2 * reach + 0.002)};
  EXPECT_FALSE(printed::Collide(bar, X_WS, bar, X_WB, Errata::None()).touching);
  EXPECT_TRUE(printed::Collide(bar, X_WS, bar, X_WB, {Erratum::kE29}).touching);
}

TEST(PrintedErrata, E30TakesACentreCloseToABoxForOneInside) {
  // 0.2 mm off an edge, to both sides: 0.28 mm along the diagonal.
  const Box A{{0.5, 0.6, 0.7}};
  const Sphere B{0.3};
  const Pose X_WA = At(0.1, 0.2, 0.3);
  const Pose X_WB = Beside(X_WA, {0.5002, 0.6002, 0.1});
  const Eigen::Vector3d diagonal =
      X_WA.R_WB * Eigen::Vector3d(1, 1, 0) / std::numbers::sqrt2;
  EXPECT_GT(printed::Collide(A, X_WA, B, X_WB, {}).n_AB_W.dot(diagonal), 1 - 1e-9);
  EXPECT_LT(printed::Collide(A, X_WA, B, X_WB, {Erratum::kE30}).n_AB_W.dot(diagonal),
            0.8);
}

}  // namespace
}  // namespace cookbook::test
