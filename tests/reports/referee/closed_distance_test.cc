// Closed forms against the search that proves the separation of any two bodies.

#include "reports/referee/closed_distance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

using referee::ClosedDistance;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Body PointAt(const Eigen::Vector3d& p_W) {
  return {Sphere{0}, Pose::FromMatrix(p_W, Eigen::Matrix3d::Identity())};
}

/** Returns the distance by the search, which does not know the closed forms. */
Enclosure Searched(const Body& body, const Eigen::Vector3d& p_W) {
  return ComputeContactTruth({body, PointAt(p_W)}).separation;
}

std::vector<Shape> ShapesOf(double size, RandomScene& random) {
  const double thin = random.Power(-4, 0) * size;
  return {Sphere{size},         random.SomeBox(size), Box{{size, thin, size}},
          Capsule{size, thin},  Capsule{thin, size},  Cylinder{size, thin},
          Cylinder{thin, size}, Cone{thin, size},     Cone{size, thin},
          HalfSpace{}};
}

/** Returns points in every region of a body: in it, around it, far from it, within
 roundings of its surface, edges and apex, and on its axis. */
std::vector<Eigen::Vector3d> PointsAbout(const Body& body, double size,
                                         RandomScene& random) {
  std::vector<Eigen::Vector3d> points;
  for (const double reach : {0.1, 0.5, 1.0, 2.0, 100.0})
    points.push_back(body.X_WB * random.Point(reach * size));
  const Eigen::Vector3d p_W = body.X_WB * random.Point(2 * size);
  const Certificate surface = ComputeContactTruth({body, PointAt(p_W)}).certificate;
  for (const double off : {0.0, 1e-16, -1e-16, 1e-13, -1e-13, 1e-6, -1e-6})
    points.push_back(surface.p_WCa + off * size * surface.n_AB_W);
  for (const double z : {-1.0, -0.3, 0.0, 0.7, 1.0})
    points.push_back(body.X_WB * Eigen::Vector3d(0, 0, z * size));
  points.push_back(body.X_WB * Eigen::Vector3d(size, size, size));
  points.push_back(body.X_WB * Eigen::Vector3d(size, 0, -size));
  return points;
}

/** Bodies of a millimetre to a kilometre, up to a thousand kilometres from the origin. */
Pose SomePose(RandomScene& random) {
  return Pose::FromQuaternion(random.Point(random.Power(-3, 6)), random.Rotation());
}

TEST(ClosedDistance, AgreesWithTheSearchInEveryRegionOfEveryShape) {
  RandomScene random(41);
  std::map<ShapeKind, int> closed;
  std::map<ShapeKind, int> asked;
  for (int i = 0; i < 60; ++i) {
    const double size = random.Power(-3, 3);
    for (const Shape& shape : ShapesOf(size, random)) {
      const Body body{shape, SomePose(random)};
      for (const Eigen::Vector3d& p_W : PointsAbout(body, size, random)) {
        SCOPED_TRACE(testing::Message() << NameOf(KindOf(shape)) << ' ' << i);
        ++asked[KindOf(shape)];
        const auto distance = ClosedDistance(body, p_W);
        if (!distance) continue;
        ++closed[KindOf(shape)];
        const Enclosure searched = Searched(body, p_W);
        EXPECT_LE(distance->lo, searched.hi);
        EXPECT_GE(distance->hi, searched.lo);
        const double reach = (p_W - body.X_WB.p_WB).norm() + BoundingRadius(shape);
        EXPECT_LE(distance->hi - distance->lo,
                  kEpsilon * std::max(reach, 32 * std::abs(distance->lo)));
      }
    }
  }
  EXPECT_EQ(closed.size(), 6U);
  // A plane has no size: a point at its origin has no scene to be a rounding of.
  asked[ShapeKind::kHalfSpace] -= 60;
  // Far points need a matrix that is a rotation to the last digits.
  for (const auto& [kind, count] : closed)
    EXPECT_GE(100 * count, 99 * asked[kind]) << NameOf(kind);
}

/** Files may give matrices that are no rotations to the last digits. The truth is that of
 the image under the matrix. */
TEST(ClosedDistance, AgreesWithTheSearchUnderAMatrixThatIsNoRotation) {
  RandomScene random(42);
  int closed = 0;
  for (int i = 0; i < 200; ++i) {
    const double skewed = random.Power(-16, -6);
    for (const Shape& shape : ShapesOf(1, random)) {
      Pose X_WB = SomePose(random);
      for (double& entry : X_WB.R_WB.reshaped()) entry += skewed * random.Uniform(-1, 1);
      const Body body{shape, Pose::FromMatrix(X_WB.p_WB, X_WB.R_WB)};
      const Eigen::Vector3d p_W = PointsAbout(body, 1, random)[5];
      const auto distance = ClosedDistance(body, p_W);
      if (!distance) continue;
      ++closed;
      const Enclosure searched = Searched(body, p_W);
      EXPECT_LE(distance->lo, searched.hi) << NameOf(KindOf(shape)) << ' ' << skewed;
      EXPECT_GE(distance->hi, searched.lo) << NameOf(KindOf(shape)) << ' ' << skewed;
    }
  }
  EXPECT_GT(closed, 1500);
}

// A matrix s·1 makes a body s times as large, and the distance of a point below it 3 − s.
// In the body's own frame it is 3/s − 1, which differs by more than a rounding.
TEST(ClosedDistance, EnclosesTheExactDistanceUnderAMatrixThatScales) {
  for (const double roundings : {-2.0, -1.0, 1.0, 2.0}) {
    const double s = 1 + roundings * kEpsilon;
    const Pose X_WB =
        Pose::FromMatrix(Eigen::Vector3d::Zero(), s * Eigen::Matrix3d::Identity());
    for (const Shape& shape :
         std::vector<Shape>{Box{{1, 1, 1}}, Cylinder{1, 1}, Cone{1, 1}}) {
      const auto distance = ClosedDistance({shape, X_WB}, {0, 0, -3});
      ASSERT_TRUE(distance) << NameOf(KindOf(shape)) << ' ' << roundings;
      EXPECT_LE(distance->lo, 3 - s) << NameOf(KindOf(shape)) << ' ' << roundings;
      EXPECT_GE(distance->hi, 3 - s) << NameOf(KindOf(shape)) << ' ' << roundings;
    }
  }
}

TEST(ClosedDistance, LeavesWhatDoublesCannotHoldToTheSearch) {
  const Box vast{{1e300, 1e300, 1e300}};
  const Box tiny{{1e-300, 1e-300, 1e-300}};
  EXPECT_FALSE(ClosedDistance({vast, Pose()}, {2e300, 0, 0}));
  EXPECT_FALSE(ClosedDistance({tiny, Pose()}, {2e-300, 0, 0}));
}

}  // namespace
}  // namespace touchstone
