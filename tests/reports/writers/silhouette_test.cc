#include "reports/writers/silhouette.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A view without an axis along a world axis.
View AwkwardView(const Vector3d& centre_W, double half_width) {
  const Eigen::Matrix3d R = Eigen::Quaterniond(0.4, -0.2, 0.8, 0.4).toRotationMatrix();
  return {R.col(0), R.col(1), centre_W, half_width};
}

double AreaOf(const Polyline& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& a = polygon[i];
    const Vector2d& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

TEST(OutlineOf, HasTheProjectedAreaOfABox) {
  // Cauchy: the projected area of a box is the sum over its axes of the face's area times
  // |axis · view|.
  const Vector3d h(0.3, 0.2, 0.7);
  const Pose X_WB =
      Pose::FromQuaternion({1, 2, 3}, Eigen::Quaterniond(0.1, 0.7, -0.1, 0.7));
  const View view = AwkwardView({1, 2, 3}, 2);
  const Vector3d v_B = X_WB.R_WB.transpose() * view.right_W.cross(view.up_W);
  const double shadow =
      4 * (h.y() * h.z() * std::abs(v_B.x()) + h.z() * h.x() * std::abs(v_B.y()) +
           h.x() * h.y() * std::abs(v_B.z()));
  // Tolerance: rounding of a dozen products of numbers near one.
  EXPECT_NEAR(AreaOf(OutlineOf({Box{h}, X_WB}, view, view.right_W)), shadow / 4, 1e-14);
}

TEST(OutlineOf, IsACircleForASphere) {
  const Vector3d centre(1, -2, 0.5);
  const View view = AwkwardView({1.1, -2.1, 0.4}, 0.5);
  const Body ball{Sphere{0.25},
                  Pose::FromQuaternion(centre, Eigen::Quaterniond::Identity())};
  for (const Vector2d& p : OutlineOf(ball, view, view.up_W)) {
    EXPECT_NEAR((p - view * centre).norm(), 0.5, 1e-14);
  }
}

TEST(OutlineOf, IsFineEnoughToBeMagnifiedWhereTheNormalPoints) {
  // Magnified a million times at the point n of a unit sphere, the outline must still be
  // the circle: within the picture its sag is (1e-6)²/2 of the radius, which is
  // invisible.
  const View whole = AwkwardView(Vector3d::Zero(), 1);
  const Vector3d n_W = (3 * whole.right_W + 4 * whole.up_W) / 5;
  View close = whole;
  close.centre_W = n_W;
  close.half_width = 1e-6;
  const Body ball{Sphere{1}, Pose{}};
  const Polyline seen = ClipToPicture(OutlineOf(ball, close, n_W));
  ASSERT_GE(seen.size(), 10u);
  const Vector2d n(0.6, 0.8);
  // The near side lies within the sag of a chord between two samples, whose step towards
  // n is at most half their distance from it: far below a hundredth of the picture.
  double nearest = -1e300;
  for (const Vector2d& p : seen) nearest = std::max(nearest, n.dot(p));
  EXPECT_NEAR(nearest, 0, 1e-2);
}

TEST(OutlineOf, EndsAtTheEdgeOfAHalfSpace) {
  const View view = AwkwardView({0.2, 0.3, 0.4}, 2);
  // The boundary passes 1 m above the centre of the view, along the view's up.
  Eigen::Matrix3d R_WB;
  R_WB.col(2) = view.up_W;
  R_WB.col(0) = view.right_W;
  R_WB.col(1) = R_WB.col(2).cross(R_WB.col(0));
  const Body ground{HalfSpace{},
                    Pose::FromMatrix(view.centre_W + view.up_W + 5 * view.right_W, R_WB)};
  double top = -1e300;
  for (const Vector2d& p : ClipToPicture(OutlineOf(ground, view, view.up_W))) {
    top = std::max(top, p.y());
  }
  EXPECT_NEAR(top, 0.5, 1e-14);
}

TEST(ClipToPicture, KeepsTheInsideAndCutsTheOutside) {
  const Polyline huge = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  EXPECT_NEAR(AreaOf(ClipToPicture(huge)), 2.2 * 2.2, 1e-12);
  const Polyline small = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}};
  EXPECT_EQ(ClipToPicture(small), small);
  EXPECT_TRUE(ClipToPicture({{3, 3}, {4, 3}, {4, 4}}).empty());
}

TEST(ClipLineToPicture, SplitsALineThatLeavesAndReturns) {
  const std::vector<Polyline> parts =
      ClipLineToPicture({{0, 0}, {0, 3}, {0.5, 3}, {0.5, 0}});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_DOUBLE_EQ(parts[0].back().y(), parts[1].front().y());
}

}  // namespace
}  // namespace touchstone
