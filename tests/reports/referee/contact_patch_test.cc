// Patches whose shape is derived by hand.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/referee/awkward_scene.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

/** Returns the contact normal: z of the frame in which the scenes are built. */
Eigen::Vector3d Up() {
  return AwkwardPose().R_WB.col(2);
}

ContactPatch PatchOf(const ContactQuery& query) {
  const Enclosure overlap = Overlap(query, Up());
  const double slack = 16 * std::numeric_limits<double>::epsilon() * SceneSize(query);
  return PatchAlong(query, Up(), -overlap.hi, slack);
}

/** Expects the corners of the patch to be those of `expected`, given in the awkward
 frame, and no others. */
void ExpectCorners(const ContactPatch& patch,
                   const std::vector<Eigen::Vector3d>& expected) {
  // Corners are accurate to some hundred roundings of a scene of size 1.
  constexpr double kRounding = 1e-13;
  EXPECT_EQ(patch.vertices_W.size(), expected.size());
  for (const Eigen::Vector3d& p : expected) {
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& v : patch.vertices_W) {
      least = std::min(least, (v - AwkwardPose() * p).norm());
    }
    EXPECT_LE(least, kRounding) << p.transpose();
  }
}

//  A's top is [-0.5, 0.5] x [-0.4, 0.4] at z = 0.3; B is [0.3, 0.7] x [-0.6, 0.2], 0.01
//  deep.
TEST(ContactPatch, FaceOnFaceIsTheRectangleTheyShareMidwayThroughTheOverlap) {
  const ContactPatch patch = PatchOf({Place(Box{{0.5, 0.4, 0.3}}, {0, 0, 0}),
                                      Place(Box{{0.2, 0.4, 0.1}}, {0.5, -0.2, 0.39})});
  ExpectCorners(
      patch,
      {{0.3, -0.4, 0.295}, {0.5, -0.4, 0.295}, {0.5, 0.2, 0.295}, {0.3, 0.2, 0.295}});
  EXPECT_EQ(patch.least_contacts, 4);
}

TEST(ContactPatch, CapsuleLyingAcrossTheRimOfABoxIsCutAtTheRim) {
  const ContactPatch patch =
      PatchOf({Place(Box{{0.5, 0.4, 0.3}}, {0, 0, 0}),
               Place(Capsule{0.1, 0.3}, {0.4, 0.1, 0.39}, Turn(M_PI / 2, {0, 1, 0}))});
  ExpectCorners(patch, {{0.1, 0.1, 0.295}, {0.5, 0.1, 0.295}});
  EXPECT_EQ(patch.least_contacts, 2);
}

TEST(ContactPatch, ParallelCapsulesTouchAlongTheSegmentTheyShare) {
  const Eigen::Quaterniond along_x = Turn(M_PI / 2, {0, 1, 0});
  const ContactPatch patch = PatchOf({Place(Capsule{0.1, 0.5}, {0, 0, 0}, along_x),
                                      Place(Capsule{0.2, 0.5}, {0.3, 0, 0.29}, along_x)});
  ExpectCorners(patch, {{-0.2, 0, 0.095}, {0.5, 0, 0.095}});
  EXPECT_EQ(patch.least_contacts, 2);
}

TEST(ContactPatch, CrossedEdgesTouchAtAPoint) {
  const double reach = std::sqrt(2.0) * 0.3;
  const ContactPatch patch =
      PatchOf({Place(Box{{0.3, 0.3, 0.3}}, {0, 0, 0}, Turn(M_PI / 4, {1, 0, 0})),
               Place(Box{{0.3, 0.3, 0.3}}, {0.1, -0.05, 2 * reach - 0.02},
                     Turn(M_PI / 4, {0, 1, 0}))});
  ExpectCorners(patch, {{0.1, 0, reach - 0.01}});
  EXPECT_EQ(patch.least_contacts, 1);
}

TEST(ContactPatch, CylinderStandingOnAFaceNeedsThreeContacts) {
  const ContactPatch patch = PatchOf({Place(Box{{0.5, 0.4, 0.3}}, {0, 0, 0}),
                                      Place(Cylinder{0.2, 0.1}, {0.1, 0.05, 0.39})});
  EXPECT_EQ(patch.least_contacts, 3);
  for (const Eigen::Vector3d& v : patch.vertices_W) {
    EXPECT_NEAR((v - AwkwardPose() * Eigen::Vector3d(0.1, 0.05, 0.295)).norm(),
                0.2 / std::cos(M_PI / 16), 1e-13);
  }
}

TEST(ContactPatch, CylinderLyingOnAPlaneTouchesAlongItsSide) {
  const ContactPatch patch =
      PatchOf({Place(HalfSpace{}, {0, 0, 0.2}),
               Place(Cylinder{0.1, 0.3}, {0.4, 0.1, 0.29}, Turn(M_PI / 2, {0, 1, 0}))});
  ExpectCorners(patch, {{0.1, 0.1, 0.195}, {0.7, 0.1, 0.195}});
  EXPECT_EQ(patch.least_contacts, 2);
}

TEST(ContactPatch, ConeStandingOnItsApexTouchesAtAPoint) {
  const ContactPatch patch =
      PatchOf({Place(HalfSpace{}, {0, 0, 0.2}),
               Place(Cone{0.1, 0.3}, {0.4, 0.1, 0.49}, Turn(M_PI, {0, 1, 0}))});
  ExpectCorners(patch, {{0.4, 0.1, 0.195}});
  EXPECT_EQ(patch.least_contacts, 1);
}

TEST(ContactPatch, TetrahedronOnAFaceNeedsThreeContacts) {
  const ConvexHull hull{
      {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0.03, 0.03, 0}, {0, 0, 0.1}}};
  const ContactPatch patch =
      PatchOf({Place(Box{{0.5, 0.4, 0.3}}, {0, 0, 0}), Place(hull, {0.1, 0.05, 0.29})});
  ExpectCorners(patch, {{0.1, 0.05, 0.295}, {0.2, 0.05, 0.295}, {0.1, 0.15, 0.295}});
  EXPECT_EQ(patch.least_contacts, 3);
}

constexpr double kFloatError =
    1e-6;  // [m], error of a float engine on a scene of this size

/** Returns Up() with the rounding error of a float. */
Eigen::Vector3d RoundedUp() {
  return Turn(1e-7, {0.3, -0.8, 0.4}) * Up();
}

ContactPatch CertainPatchOf(const ContactQuery& query, const Eigen::Vector3d& n_W,
                            double e = kFloatError) {
  const double flush = 16 * std::numeric_limits<double>::epsilon() * SceneSize(query);
  return CertainPatch(query, n_W, -Overlap(query, Up()).hi, flush, e);
}

TEST(CertainPatch, AlongARoundedNormalIsStillTheWholeFace) {
  const ContactQuery query = {Place(Box{{0.5, 0.4, 0.3}}, {0, 0, 0}),
                              Place(Box{{0.2, 0.4, 0.1}}, {0.5, -0.2, 0.39})};
  for (const ContactPatch& patch :
       {CertainPatchOf(query, RoundedUp()), CertainPatchOf(query, Up(), 1e-14)}) {
    ExpectCorners(
        patch,
        {{0.3, -0.4, 0.295}, {0.5, -0.4, 0.295}, {0.5, 0.2, 0.295}, {0.3, 0.2, 0.295}});
    EXPECT_EQ(patch.least_contacts, 4);
  }
  EXPECT_LT(PatchAlong(query, RoundedUp(), -0.01, 1e-15).vertices_W.size(), 4U);
}

TEST(CertainPatch, AlongARoundedNormalIsStillTheSegmentOfParallelCapsules) {
  const Eigen::Quaterniond along_x = Turn(M_PI / 2, {0, 1, 0});
  const ContactPatch patch =
      CertainPatchOf({Place(Capsule{0.1, 0.5}, {0, 0, 0}, along_x),
                      Place(Capsule{0.2, 0.5}, {0.3, 0, 0.29}, along_x)},
                     RoundedUp());
  EXPECT_EQ(patch.vertices_W.size(), 2U);
  EXPECT_EQ(patch.least_contacts, 2);
}

// About a slanting axis the lowest feature is a corner, about an axis of the boxes it is
// an edge. To a float engine the whole face is as low.
TEST(CertainPatch, OfFacesThatTheQuestionTiltsIsAPoint) {
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(0, 1, 0)}) {
    const ContactPatch patch =
        CertainPatchOf({Place(Box{{0.9, 0.4, 0.3}}, {0, 0, 0}),
                        Place(Box{{0.4, 0.3, 0.1}}, {-0.3, 0, 0.39}, Turn(1e-8, axis))},
                       RoundedUp());
    EXPECT_EQ(patch.vertices_W.size(), 1U);
  }
}

// A float engine takes the end of the cylinder for flush, and may span it by a triangle:
// the lowest arc, within the rounding of the question, is not required of it.
TEST(CertainPatch, OfADiscThatTheQuestionTiltsIsAPoint) {
  for (const double tilt : {1e-15, 1e-8}) {
    const ContactPatch patch = CertainPatchOf(
        {Place(Box{{0.5, 0.4, 0.3}}, {0, 0, 0}),
         Place(Cylinder{0.2, 0.1}, {0.1, 0.05, 0.39}, Turn(tilt, {1, 0.3, 0}))},
        Up());
    EXPECT_EQ(patch.least_contacts, tilt < 1e-12 ? 3 : 1);
  }
}

TEST(CertainPatch, OnAHalfSpaceIsSeenAlongItsOwnNormal) {
  const auto tilted_by = [](double angle) {
    return CertainPatchOf(
        {Place(HalfSpace{}, {0, 0, 0.2}),
         Place(Box{{0.1, 0.2, 0.1}}, {0, 0, 0.29}, Turn(angle, {1, 2, 0}))},
        Up());
  };
  EXPECT_EQ(tilted_by(0).vertices_W.size(), 4U);
  EXPECT_EQ(tilted_by(1e-8).vertices_W.size(), 1U);
}

/** Returns the patch that an engine in doubles must not miss. */
ContactPatch CertainInDoubles(const ContactQuery& query) {
  const ContactTruth truth = ComputeContactTruth(query);
  const double e = 64 * 0x1p-53 * SceneSize(query) + truth.input_rounding;
  return CertainPatch(query, truth.certificate.n_AB_W.normalized(), truth.separation.lo,
                      truth.input_rounding, e);
}

// The tilt is more than the question's rounding and less than the 64 roundings of the
// scene that a double engine may be off by: one that is exact returns fewer corners.
TEST(CertainPatch, OfAFaceTiltedByAFractionOfTheAccuracyOfDoublesIsAPoint) {
  for (const double tilt : {2e-15, 4e-15, 6e-15}) {
    const ContactQuery query = {
        Place(HalfSpace{}, {0, 0, 0.2}),
        Place(Box{{0.1, 0.2, 0.1}}, {0, 0, 0.29}, Turn(tilt, {1, 2, 0}))};
    const double e = 64 * 0x1p-53 * SceneSize(query);
    const double highest = tilt * 2 * (1 * 0.2 + 2 * 0.1) / std::sqrt(5.0);
    ASSERT_LT(highest, e);
    EXPECT_EQ(CertainPatch(query, Up(), -0.01, 0, e).vertices_W.size(), 1U) << tilt;
  }
}

// The direction along which slender faces are flat is far better known across them than a
// double can say: rounded to one, they appear tilted by the square of their ratio.
TEST(CertainPatch, OfSlenderFlushFacesIsTheWholeFaceInAnyFrame) {
  RandomScene random(7);
  for (const double width : {1.0, 0.1, 0.03, 0.01, 0.001}) {
    for (int i = 0; i < 40; ++i) {
      const Eigen::Quaterniond q = random.Rotation();
      const auto place = [&](const Shape& shape, const Eigen::Vector3d& p) {
        return Body{shape, Pose::FromQuaternion(q * p, q)};
      };
      const Box plank{{1, width, 0.3}};
      EXPECT_EQ(CertainInDoubles({place(plank, {0, 0, 0}), place(plank, {0.1, 0, 0.59})})
                    .vertices_W.size(),
                4U)
          << width;
      // A capsule's axis is along z: it lies on the plank's side.
      const Box post{{width, 0.3, 1}};
      EXPECT_EQ(CertainInDoubles(
                    {place(post, {0, 0, 0}), place(Capsule{0.2, 0.5}, {0, 0.49, 0})})
                    .vertices_W.size(),
                2U)
          << width;
    }
  }
}

TEST(CertainPatch, OfASliverIsASegmentAndOfASpeckAPoint) {
  const auto shared = [](double x, double y) {
    return CertainPatchOf({Place(Box{{0.5, 0.4, 0.3}}, {0, 0, 0}),
                           Place(Box{{0.2, 0.2, 0.1}}, {0.7 - x, 0.6 - y, 0.39})},
                          Up());
  };
  EXPECT_EQ(shared(0.1, 0.1).least_contacts, 4);
  EXPECT_EQ(shared(8 * kFloatError, 0.1).least_contacts, 2);
  EXPECT_EQ(shared(8 * kFloatError, 8 * kFloatError).least_contacts, 1);
}

}  // namespace
}  // namespace touchstone
