#include "reports/contacts/checks/contact_off_patch.h"

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

TEST(ContactOffPatch, IsNoneAtAndBetweenTheCorners) {
  const Specimen s = BoxOnBoxFace(kDepth);
  const ContactPatch patch = LowerFaceOf(s);
  ContactPoint middle = s.right.points[0];
  middle.p_WC = (s.right.points[0].p_WC + s.right.points[2].p_WC) / 2;
  EXPECT_EQ(ContactOffPatch(patch, *s.right.n_AB_W, middle), 0);
  for (const ContactPoint& contact : s.right.points) {
    EXPECT_LE(ContactOffPatch(patch, *s.right.n_AB_W, contact), kRounding);
  }
}

TEST(ContactOffPatch, IsTheDistanceBeyondTheEdge) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactPoint contact = s.right.points[0];
  contact.p_WC += 0.011 * s.query.B.X_WB.R_WB.col(0);
  EXPECT_NEAR(ContactOffPatch(LowerFaceOf(s), *s.right.n_AB_W, contact), 0.011,
              kRounding);
}

TEST(ContactOffPatch, DoesNotCountTheDistanceAlongTheNormal) {
  const Specimen s = SphereInBoxFace(kDepth);
  ContactPatch point;
  point.vertices_W = {s.right.points[0].p_WC};
  ContactPoint contact = s.right.points[0];
  contact.p_WC += 0.4 * *s.right.n_AB_W;
  EXPECT_LE(ContactOffPatch(point, *s.right.n_AB_W, contact), kRounding);
}

TEST(OffsetFromPatch, IsAsLongAsTheDistanceAndLeavesThePatchBehind) {
  const Specimen s = BoxOnBoxFace(kDepth);
  const ContactPatch patch = LowerFaceOf(s);
  const Eigen::Vector3d& n_W = *s.right.n_AB_W;
  ContactPoint contact = s.right.points[0];
  EXPECT_LE(OffsetFromPatch(patch, n_W, contact).norm(), kRounding);
  contact.p_WC += 0.011 * s.query.B.X_WB.R_WB.col(0) + 0.3 * n_W;
  const Eigen::Vector3d off_W = OffsetFromPatch(patch, n_W, contact);
  EXPECT_DOUBLE_EQ(off_W.norm(), ContactOffPatch(patch, n_W, contact));
  EXPECT_NEAR(off_W.dot(n_W), 0, kRounding);
  const Eigen::Vector3d nearest_W = contact.p_WC - off_W;
  for (const Eigen::Vector3d& corner_W : patch.vertices_W)
    EXPECT_LE(off_W.dot(corner_W - nearest_W), kRounding);
}

}  // namespace
}  // namespace touchstone
