// The contacts of two boxes whose geometry is known by construction.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "engine/collision/collide.h"
#include "engine/collision/rounding.h"
#include "tests/engine/random_boxes.h"

namespace cookbook::test {
namespace {

/** Calls `check` at a hundred poses of A: a case built in A's frame must hold at any. */
template <class Check>
void InManyPlaces(const Check& check) {
  Random random(7);
  for (int k = 0; k < 100 && !testing::Test::HasFailure(); ++k) {
    Pose X_WA;
    X_WA.R_WB = random.Rotation();
    X_WA.p_WB = 5 * random.Direction();
    check(X_WA, random);
  }
}

Pose Placed(const Pose& X_WA, const Eigen::Matrix3d& R_AB,
            const Eigen::Vector3d& p_AB_A) {
  return {X_WA.R_WB * R_AB, X_WA.p_WB + X_WA.R_WB * p_AB_A};
}

double DeepestOf(const Manifold& manifold) {
  double deepest = manifold.contacts[0].separation;
  for (const ContactPoint& contact : manifold.points()) {
    deepest = std::min(deepest, contact.separation);
  }
  return deepest;
}

/** kDepthRounding for pairs whose size |p_AB|₁ + |h_A|₁ + |h_B|₁ is below 8 m. [m] */
constexpr double kRounding = 8 * kDepthRounding;

/** Returns the least sine of the angles at which edges of A and of B cross, projected
 along `n_W`. Two edges are skipped if the product of their projected unit lengths is at
 most 1/4: such edges do not bound the faces in contact, whose normals are at most
 acos(√⅓) off n_W. */
double LeastSine(const BoxQuestion& q, const Eigen::Vector3d& n_W) {
  double least = 1;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d a = q.X_WA.R_WB.col(i);
      const Eigen::Vector3d b = q.X_WB.R_WB.col(j);
      const double seen = a.cross(n_W).norm() * b.cross(n_W).norm();
      if (seen > 0.25) least = std::min(least, std::abs(n_W.dot(a.cross(b))) / seen);
    }
  }
  return least;
}

const Box kFloor{{1.1, 0.3, 0.9}};  // Its upper face is at y = 0.3.

TEST(BoxOnFace, FlatHasTheFourCornersOfTheSmallerFace) {
  const Box B{{0.2, 0.15, 0.35}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    const double depth = random.Below(2) == 0 ? 0 : random.Between(0, 0.1);
    const Pose X_WB = Placed(X_WA, Turn(Eigen::Vector3d::UnitY(), random.Between(0, 3)),
                             {0.1, 0.45 - depth, -0.2});
    const Manifold manifold = Collide(kFloor, X_WA, B, X_WB);
    if (!manifold.touching) {
      EXPECT_EQ(depth, 0) << "only exact touch may be lost to rounding";
      EXPECT_LT(manifold.separation, kRounding);
      return;
    }
    EXPECT_EQ(manifold.count, 4);
    EXPECT_LT((manifold.n_AB_W - X_WA.R_WB.col(1)).norm(), kRounding);
    for (const ContactPoint& contact : manifold.points()) {
      EXPECT_NEAR(contact.separation, -depth, kRounding);
      // Midway through the overlap, at a corner of B's lower face.
      const Eigen::Vector3d p_BC = X_WB.R_WB.transpose() * (contact.p_WC - X_WB.p_WB);
      EXPECT_NEAR(std::abs(p_BC[0]), 0.2, kRounding);
      EXPECT_NEAR(p_BC[1], -0.15 + depth / 2, kRounding);
      EXPECT_NEAR(std::abs(p_BC[2]), 0.35, kRounding);
    }
  });
}

TEST(BoxOnFace, FlushFacesOfEqualBoxesHaveFourContacts) {
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    const Pose X_WB =
        Placed(X_WA, Turn(Eigen::Vector3d::UnitY(), random.Between(-1e-16, 1e-16)),
               {0, 0.6 - 1e-3, 0});
    EXPECT_EQ(Collide(kFloor, X_WA, kFloor, X_WB).count, 4);
  });
}

TEST(BoxOnFace, SquaresTurnedBy45DegreesMeetInAnOctagon) {
  const Box cube{{0.5, 0.5, 0.5}};
  InManyPlaces([&](const Pose& X_WA, Random&) {
    const Pose X_WB = Placed(X_WA, Turn(Eigen::Vector3d::UnitY(), std::numbers::pi / 4),
                             {0, 1 - 1e-3, 0});
    const Manifold manifold = Collide(cube, X_WA, cube, X_WB);
    ASSERT_EQ(manifold.count, 8);
    for (const ContactPoint& contact : manifold.points()) {
      const Eigen::Vector3d p_AC = X_WA.R_WB.transpose() * (contact.p_WC - X_WA.p_WB);
      // Corners of a regular octagon of inradius 1/2: coordinates 1/2 and tan(π/8)/2.
      const double large = std::max(std::abs(p_AC[0]), std::abs(p_AC[2]));
      const double small = std::min(std::abs(p_AC[0]), std::abs(p_AC[2]));
      EXPECT_NEAR(large, 0.5, kRounding);
      EXPECT_NEAR(small, 0.5 * std::tan(std::numbers::pi / 8), kRounding);
    }
  });
}

TEST(BoxOnFace, EdgeOnFaceHasTwoContactsWhateverTheTilt) {
  const Box B{{0.2, 0.25, 0.3}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    // Turned about z, B stands on a level edge and rises on both sides of it.
    const double tilt = random.Between(0.1, 1.4);
    const double depth = random.Below(3) == 0 ? 1e-16 : random.Between(0, 0.01);
    const double lowest = 0.2 * std::sin(tilt) + 0.25 * std::cos(tilt);
    const Pose X_WB = Placed(X_WA, Turn(Eigen::Vector3d::UnitZ(), tilt),
                             {0.1, 0.3 + lowest - depth, -0.2});
    const Manifold manifold = Collide(kFloor, X_WA, B, X_WB);
    if (!manifold.touching && depth < kRounding) return;
    ASSERT_EQ(manifold.count, 2);
    for (const ContactPoint& contact : manifold.points()) {
      EXPECT_NEAR(contact.separation, -depth, kRounding);
    }
    EXPECT_NEAR((manifold.contacts[0].p_WC - manifold.contacts[1].p_WC).norm(), 0.6,
                kRounding);
  });
}

TEST(BoxOnFace, EdgeAcrossTheRimHasTwoContactsOneOfThemOnTheRim) {
  const Box B{{0.2, 0.25, 2}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    const double tilt = random.Between(0.3, 1.2);
    const double lowest = 0.2 * std::sin(tilt) + 0.25 * std::cos(tilt);
    const Pose X_WB = Placed(X_WA, Turn(Eigen::Vector3d::UnitZ(), tilt),
                             {0.1, 0.3 + lowest - 0.01, 1.9});
    const Manifold manifold = Collide(kFloor, X_WA, B, X_WB);
    ASSERT_EQ(manifold.count, 2);
    // B reaches from z = −0.1 over the rim at 0.9.
    EXPECT_NEAR((manifold.contacts[0].p_WC - manifold.contacts[1].p_WC).norm(), 1.0,
                kRounding);
  });
}

TEST(BoxOnFace, VertexOnFaceHasOneContact) {
  const Box B{{0.2, 0.25, 0.3}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    const Eigen::Matrix3d R_AB =
        Turn(Eigen::Vector3d::UnitZ(), random.Between(0.3, 1.2)) *
        Turn(Eigen::Vector3d::UnitX(), random.Between(0.3, 1.2));
    const double depth = random.Below(3) == 0 ? 1e-16 : random.Between(0, 0.01);
    const double lowest = R_AB.row(1).cwiseAbs().dot(B.half_extents);
    const Pose X_WB = Placed(X_WA, R_AB, {0.1, 0.3 + lowest - depth, -0.2});
    const Manifold manifold = Collide(kFloor, X_WA, B, X_WB);
    if (!manifold.touching && depth < kRounding) return;
    EXPECT_EQ(manifold.count, 1);
    EXPECT_NEAR(manifold.separation, -depth, kRounding);
  });
}

TEST(BoxOnFace, SlightlyTiltedBoxKeepsItsShallowCorners) {
  const Box B{{0.2, 0.15, 0.35}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    const double tilt = random.Between(1e-9, 1e-3);
    const Pose X_WB =
        Placed(X_WA, Turn(Eigen::Vector3d::UnitX(), tilt), {0.1, 0.449, -0.2});
    const Manifold manifold = Collide(kFloor, X_WA, B, X_WB);
    ASSERT_EQ(manifold.count, 4);
    // The ends are 0.7 apart, so the two depths differ by 0.7 sin(tilt).
    double shallowest = DeepestOf(manifold);
    for (const ContactPoint& contact : manifold.points()) {
      shallowest = std::max(shallowest, contact.separation);
    }
    EXPECT_NEAR(shallowest - DeepestOf(manifold), 0.7 * std::sin(tilt), kRounding);
  });
}

TEST(BoxOnFace, AlmostFlatHasFourContactsEvenIfAPairOfEdgesIsBest) {
  // B lies across the floor, and edges of both bound their common patch. A nearly
  // parallel pair of these edges may beat both faces by a little more than rounding.
  const Box B{{1.5, 0.15, 0.35}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    for (int k = 0; k < 50; ++k) {
      const double tilt = std::pow(10, -random.Between(5, 17));
      const Pose X_WB = Placed(X_WA, Turn(random.Direction(), tilt), {0.05, 0.449, -0.1});
      const Manifold manifold = Collide(kFloor, X_WA, B, X_WB);
      ASSERT_EQ(manifold.count, 4) << "tilted by " << tilt;
      double widest = 0;
      for (const ContactPoint& p : manifold.points()) {
        for (const ContactPoint& q : manifold.points()) {
          widest = std::max(widest, (p.p_WC - q.p_WC).norm());
        }
      }
      // The diagonal of the common rectangle, 2.2 by 0.7, and the effect of the tilt.
      EXPECT_NEAR(widest, std::hypot(2.2, 0.7), 10 * tilt + kRounding);
    }
  });
}

TEST(BoxOnBox, DeepestContactHasTheSeparationWhereACornerMeetsTheRim) {
  // A corner of B is above the rim of the floor, off it by no more than rounding. Its
  // steep edges are clipped there, to candidates at one point but of different depths.
  const Box B{{0.2, 0.25, 0.3}};
  const double size = 5;  // |p_AB|₁ + |h_A|₁ + |h_B|₁ is less. [m]
  int touching = 0;
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    for (int k = 0; k < 200; ++k) {
      const Eigen::Matrix3d R_AB = random.Rotation();
      const Eigen::Vector3d corner_B =
          -(R_AB.row(1).array().sign() * B.half_extents.transpose().array());
      const double beside = random.Between(-1, 1) * kDepthRounding * size;
      const double depth = random.Between(0, 1) * kDepthRounding * size;
      const Eigen::Vector3d corner_A(1.1 + beside, 0.3 - depth, -0.2);
      const Pose X_WB = Placed(X_WA, R_AB, corner_A - R_AB * corner_B);
      const Manifold manifold = Collide(kFloor, X_WA, B, X_WB);
      if (!manifold.touching) continue;
      ++touching;
      ASSERT_NEAR(DeepestOf(manifold), manifold.separation,
                  (kFlush + kOverlapRounding) * size);
    }
  });
  EXPECT_GT(touching, 2000);
}

TEST(BoxOnBox, CrossedEdgesHaveOneContactMidway) {
  const Box cube{{0.5, 0.5, 0.5}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    // A stands on an edge along x, its highest edge at y = √½. B stands on an edge turned
    // from that by `yaw`. Only the two edges meet, above A's centre, and n = y.
    const Eigen::Matrix3d on_edge = Turn(Eigen::Vector3d::UnitX(), std::numbers::pi / 4);
    const double yaw = random.Between(0.4, 2.7);
    const double depth = random.Between(1e-6, 0.05);
    const Eigen::Vector3d above(0.11, std::numbers::sqrt2 - depth, -0.07);
    const Pose X_WS = {X_WA.R_WB * on_edge, X_WA.p_WB};
    const Pose X_WB = Placed(X_WA, Turn(Eigen::Vector3d::UnitY(), yaw) * on_edge, above);
    const Manifold manifold = Collide(cube, X_WS, cube, X_WB);
    ASSERT_EQ(manifold.count, 1);
    EXPECT_NEAR(manifold.separation, -depth, kRounding);
    EXPECT_LT((manifold.n_AB_W - X_WA.R_WB.col(1)).norm(), kRounding);
    // B's lower edge passes through (0.11, ·, −0.07) along (cos yaw, 0, −sin yaw) and
    // meets A's upper edge, z = 0, after −0.07 / sin yaw.
    const Eigen::Vector3d p_AC =
        X_WA.R_WB.transpose() * (manifold.contacts[0].p_WC - X_WA.p_WB);
    EXPECT_NEAR(p_AC[0], 0.11 - 0.07 * std::cos(yaw) / std::sin(yaw), 4 * kRounding);
    EXPECT_NEAR(p_AC[1], std::sqrt(0.5) - depth / 2, kRounding);
    EXPECT_NEAR(p_AC[2], 0, 4 * kRounding);
  });
}

TEST(BoxInBox, ShortestWayOutIsThroughTheNearestFace) {
  InManyPlaces([&](const Pose& X_WA, Random&) {
    // Half size 0.2 in 1.0, 0.2 off centre along x: 1.0 − 0.2 + 0.2 to the plane x = 1.
    const Pose X_WB = Placed(X_WA, Eigen::Matrix3d::Identity(), {0.2, 0.03, -0.05});
    const Manifold manifold = Collide(Box{{1, 1, 1}}, X_WA, Box{{0.2, 0.2, 0.2}}, X_WB);
    EXPECT_NEAR(manifold.separation, -1.0, kRounding);
    EXPECT_LT((manifold.n_AB_W - X_WA.R_WB.col(0)).norm(), kRounding);
    ASSERT_EQ(manifold.count, 4);
    for (const ContactPoint& contact : manifold.points()) {
      // Between B's inner face, x = 0, and A's face, x = 1.
      EXPECT_NEAR((X_WA.R_WB.transpose() * (contact.p_WC - X_WA.p_WB))[0], 0.5,
                  kRounding);
    }
  });
}

TEST(BoxInBox, ConcentricBoxesTouch) {
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    const Pose X_WB = {random.Rotation(), X_WA.p_WB};
    const Manifold manifold = Collide(kFloor, X_WA, Box{{0.02, 0.03, 0.04}}, X_WB);
    EXPECT_TRUE(manifold.touching);
    EXPECT_GE(manifold.count, 1);
    EXPECT_LT(manifold.separation, -0.3);
  });
}

TEST(BoxOnBox, SwappingBodiesOnlyNegatesTheNormal) {
  Random random(11);
  int touching = 0;
  for (int k = 0; k < 5000; ++k) {
    const BoxQuestion q = AnyBoxes(random);
    const Manifold forth = Collide(q.A, q.X_WA, q.B, q.X_WB);
    const Manifold back = Collide(q.B, q.X_WB, q.A, q.X_WA);
    ASSERT_EQ(forth.touching, back.touching);
    if (!forth.touching) continue;
    ++touching;
    EXPECT_NEAR(forth.separation, back.separation, kRounding);
    ASSERT_EQ(forth.count, back.count);
    EXPECT_LT((forth.n_AB_W + back.n_AB_W).norm(), 1e-12);
    // The crossing of lines known to within rounding is known to within rounding / sine.
    const double allowed = kRounding / LeastSine(q, forth.n_AB_W);
    for (const ContactPoint& contact : forth.points()) {
      double nearest = 1;
      for (const ContactPoint& other : back.points()) {
        nearest = std::min(nearest, (contact.p_WC - other.p_WC).norm());
      }
      EXPECT_LT(nearest, allowed);
    }
  }
  EXPECT_GT(touching, 2000);
}

TEST(BoxOnBox, FeaturesKeepTheirIdsWhileTheBoxSlides) {
  const Box B{{0.2, 0.15, 0.35}};
  InManyPlaces([&](const Pose& X_WA, Random& random) {
    const Eigen::Matrix3d R_AB = Turn(Eigen::Vector3d::UnitY(), 0.3);
    const auto FeaturesAt = [&](double x, double yaw) {
      const Manifold manifold = Collide(
          kFloor, X_WA, B,
          Placed(X_WA, R_AB * Turn(Eigen::Vector3d::UnitY(), yaw), {x, 0.449, -0.75}));
      std::set<FeatureId> features;
      for (const ContactPoint& contact : manifold.points())
        features.insert(contact.feature);
      return features;
    };
    // B overhangs the rim z = −0.9, so two of the four contacts are made by clipping.
    const std::set<FeatureId> before = FeaturesAt(0.1, 0);
    EXPECT_EQ(before.size(), 4u);
    EXPECT_EQ(before,
              FeaturesAt(0.1 + random.Between(-0.1, 0.1), random.Between(-1e-4, 1e-4)));
  });
}

}  // namespace
}  // namespace cookbook::test
