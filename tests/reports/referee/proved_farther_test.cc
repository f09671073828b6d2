// The filter in double against the certified distance, which it must never contradict.

#include "reports/referee/proved_farther.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

using referee::IsProvedFarther;

std::vector<Shape> ShapesOf(double size, RandomScene& random) {
  const double thin = random.Power(-6, 0) * size;
  return {Sphere{size},
          random.SomeBox(size),
          Capsule{thin, size},
          Box{{size, thin, size}},
          Cylinder{size, thin},
          Cone{thin, size},
          random.SomeHull(size, 12)};
}

/** Returns the direction in which the distance from `body` grows fastest at `p_W`, by
 central differences over 1e-6 of `size`. */
Eigen::Vector3d Gradient(const Body& body, const Eigen::Vector3d& p_W, double size) {
  Eigen::Vector3d gradient;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = 1e-6 * size * Eigen::Vector3d::Unit(i);
    gradient[i] =
        SignedDistance(body, p_W + step).lo - SignedDistance(body, p_W - step).lo;
  }
  return gradient.normalized();
}

/** Points at every distance from touching to far, about bodies of 1e-3 to 1e3 m, needles
 and plates among them, up to a thousand kilometres from the origin. */
TEST(IsProvedFarther, IsNeverTrueOfAPointThatIsCertifiedToBeNearer) {
  RandomScene random(7);
  std::map<ShapeKind, int> proved;
  for (int i = 0; i < 60; ++i) {
    const double size = random.Power(-3, 3);
    const Pose X_WB =
        Pose::FromQuaternion(random.Point(random.Power(-3, 6)), random.Rotation());
    for (const Shape& shape : ShapesOf(size, random)) {
      const Body body{shape, X_WB};
      const Eigen::Vector3d p_W = X_WB * random.Point(2 * size);
      const Eigen::Vector3d n_W = Gradient(body, p_W, size);
      const Enclosure certified = SignedDistance(body, p_W);
      // Distances to both sides of the truth, from some ulps off it to far.
      for (const double off : {0.0, 1e-16, 1e-14, 1e-10, 1e-6, 1e-2}) {
        for (const double distance : {certified.lo * (1 - off), certified.lo - off * size,
                                      certified.hi, certified.hi + off * size}) {
          if (!IsProvedFarther(body, p_W, n_W, distance)) continue;
          ++proved[KindOf(shape)];
          EXPECT_GT(certified.hi, distance) << i << ' ' << shape.index();
        }
      }
    }
  }
  EXPECT_EQ(proved.size(), 6U);
  for (const auto& [kind, count] : proved) EXPECT_GT(count, 100) << NameOf(kind);
}

TEST(IsProvedFarther, FindsPointsJustOffAFaceAnEdgeOrACornerOfABox) {
  RandomScene random(8);
  for (int i = 0; i < 200; ++i) {
    const Box box = random.SomeBox(1);
    const Body body{box, Pose::FromQuaternion(random.Point(1), random.Rotation())};
    const Eigen::Vector3d h = box.half_extents;
    const double off = 1e-7;  // [m], as far as a contact is pushed beyond its surface
    for (const Eigen::Vector3d& q :
         {Eigen::Vector3d(h.x() + off, 0.3 * h.y(), -0.8 * h.z()),
          Eigen::Vector3d(-h.x() - off, h.y() + off, 0.1 * h.z()),
          Eigen::Vector3d(h.x() + off, h.y() + off, -h.z() - off)}) {
      // A direction that proves nothing, so that the nearest point must.
      const Eigen::Vector3d across_W = body.X_WB.R_WB * q.unitOrthogonal();
      EXPECT_TRUE(IsProvedFarther(body, body.X_WB * q, across_W, 0.9 * off));
      EXPECT_FALSE(IsProvedFarther(body, body.X_WB * q, across_W, 2 * off));
    }
  }
}

TEST(IsProvedFarther, FindsPointsOffARoundBodyAlongItsNormal) {
  const Body cylinder{
      Cylinder{0.3, 0.4},
      Pose::FromQuaternion({0.1, 0.2, 0.3},
                           Eigen::Quaterniond(0.61, -0.35, 0.52, 0.48).normalized())};
  const Eigen::Vector3d n_W = cylinder.X_WB.R_WB.col(2);
  const Eigen::Vector3d p_W = cylinder.X_WB * Eigen::Vector3d(0.1, 0.1, 0.4 + 1e-7);
  EXPECT_TRUE(IsProvedFarther(cylinder, p_W, n_W, 0.9e-7));
  EXPECT_FALSE(IsProvedFarther(cylinder, p_W, n_W, 1.1e-7));
}

TEST(IsProvedFarther, ProvesNothingOfAHalfSpace) {
  const Body floor{HalfSpace{}, Pose{}};
  EXPECT_FALSE(IsProvedFarther(floor, {0, 0, 1}, {0, 0, 1}, 0.5));
}

}  // namespace
}  // namespace touchstone
