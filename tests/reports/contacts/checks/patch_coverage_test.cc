#include "reports/contacts/checks/patch_coverage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

TEST(ShortfallAt, ProvesTheShareThatIsUnspannedAtAPoint) {
  // A slab, since the stretched plane differs from the plane itself.
  ContactPatch patch;
  patch.vertices_W = {{1, 0.1, 0}, {-1, 0.1, 0}, {-1, -0.1, 0}, {1, -0.1, 0}};
  const Eigen::Vector3d n_W = Eigen::Vector3d::UnitZ();
  const std::vector<ContactPoint> contacts = {
      {{0.9, 0.02, 0}, -1e-3, {}}, {{-1, 0.1, 0}, -1e-3, {}}, {{0, -0.1, 0}, -1e-3, {}}};
  for (const Eigen::Vector3d& corner_W : patch.vertices_W) {
    const Eigen::Vector3d d_W = ShortfallAt(corner_W, patch, n_W, contacts);
    double least = 1;
    for (const ContactPoint& contact : contacts)
      least = std::min(least, d_W.dot(corner_W - contact.p_WC));
    EXPECT_NEAR(least, UnspannedAt(corner_W, patch, n_W, contacts), 1e-14);
    EXPECT_EQ(d_W.z(), 0);
  }
}

double Unspanned(const Specimen& s, std::span<const ContactPoint> contacts) {
  return PatchUnspanned(LowerFaceOf(s), *s.right.n_AB_W, contacts);
}

TEST(PatchCoverage, IsWholeWithEveryCorner) {
  const Specimen s = BoxOnBoxFace(kDepth);
  // 2^-46 m over a face 0.1 m wide.
  EXPECT_LE(Unspanned(s, s.right.points), 10 * kRounding);
}

TEST(PatchCoverage, IsHalfWithOneContactInTheMiddle) {
  const Specimen s = BoxOnBoxFace(kDepth);
  ContactPoint middle = s.right.points[0];
  middle.p_WC = (s.right.points[0].p_WC + s.right.points[2].p_WC) / 2;
  EXPECT_NEAR(Unspanned(s, std::span(&middle, 1)), 0.5, 10 * kRounding);
}

TEST(PatchCoverage, IsHalfWithAMissingCorner) {
  // The fourth corner is half a diagonal from the line between its neighbours, whatever
  // the sides' ratio.
  const Specimen s = BoxOnBoxFace(kDepth);
  EXPECT_NEAR(Unspanned(s, std::span(s.right.points).first(3)), 0.5, 10 * kRounding);
}

TEST(PatchCoverage, CountsTheWidthOfASlabLikeItsLength) {
  // A face of 2 m by 1 cm, held along its middle line only.
  ContactPatch patch;
  patch.vertices_W = {{1, 0.005, 0}, {-1, 0.005, 0}, {-1, -0.005, 0}, {1, -0.005, 0}};
  const std::vector<ContactPoint> line = {{{1, 0, 0}, -1e-3, {}},
                                          {{-1, 0, 0}, -1e-3, {}}};
  EXPECT_GT(PatchUnspanned(patch, Eigen::Vector3d::UnitZ(), line), kLegalUnspanned);
}

TEST(PatchCoverage, CountsTheWidthOfANeedleLikeItsLength) {
  // A needle held along one of its long edges only can turn about it.
  const Eigen::Vector3d along = AwkwardPose().R_WB.col(0);
  const Eigen::Vector3d across = AwkwardPose().R_WB.col(1);
  const Eigen::Vector3d n = AwkwardPose().R_WB.col(2);
  for (const double half_width : {1e-4, 1e-6, 1e-12}) {
    ContactPatch patch;
    patch.vertices_W = {along + half_width * across, -along + half_width * across,
                        -along - half_width * across, along - half_width * across};
    const std::vector<ContactPoint> edge = {{patch.vertices_W[2], -1e-3, {}},
                                            {patch.vertices_W[3], -1e-3, {}}};
    EXPECT_GT(PatchUnspanned(patch, n, edge), kLegalUnspanned) << half_width;
  }
}

TEST(PatchCoverage, OfASegmentFarAwayTakesItsRoundingForNoWidth) {
  const Eigen::Vector3d p(731.1, -417.3, 919.7);
  const Eigen::Vector3d half = 0.1 * AwkwardPose().R_WB.col(0);
  ContactPatch segment;
  segment.vertices_W = {p - half, p + half};
  const Eigen::Vector3d n = AwkwardPose().R_WB.col(2);
  // The contacts at the ends are a hundred roundings of the coordinates off, across the
  // segment.
  const Eigen::Vector3d off = 1e-11 * AwkwardPose().R_WB.col(1);
  const std::vector<ContactPoint> ends = {{p - half + off, -1e-3, {}},
                                          {p + half + off, -1e-3, {}}};
  EXPECT_LE(PatchUnspanned(segment, n, ends), 1e-10);
}

TEST(PatchCoverage, OfADiscAllowsAnInscribedTriangle) {
  ContactPatch disc;
  std::vector<ContactPoint> triangle;
  for (int i = 0; i < 48; ++i) {
    const double angle = 0.3 + i * 2 * std::numbers::pi / 48;
    const Eigen::Vector3d p(std::cos(angle), std::sin(angle), 0);
    disc.vertices_W.push_back(p);
    if (i % 16 == 0) triangle.push_back({p, -1e-3, {}});
  }
  const Eigen::Vector3d n = Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(PatchUnspanned(disc, n, triangle), kInscribedUnspanned, 1e-12);
  EXPECT_GT(PatchUnspanned(disc, n, std::span(triangle).first(2)), kInscribedUnspanned);
}

TEST(PatchCoverage, OfADiscInItsPolygonAllowsAnInscribedTriangleAtAnyTurn) {
  constexpr int kSides = 16;
  ContactPatch disc;
  disc.least_contacts = 3;
  for (int i = 0; i < kSides; ++i) {
    const double angle = i * 2 * std::numbers::pi / kSides;
    disc.vertices_W.push_back(Eigen::Vector3d(std::cos(angle), std::sin(angle), 0) /
                              std::cos(std::numbers::pi / kSides));
  }
  const Eigen::Vector3d n = Eigen::Vector3d::UnitZ();
  const auto triangle_at = [&](double turn, double radius) {
    std::vector<ContactPoint> triangle;
    for (int i = 0; i < 3; ++i) {
      const double angle = turn + i * 2 * std::numbers::pi / 3;
      triangle.push_back(
          {radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0), -1e-3, {}});
    }
    return triangle;
  };
  double most = 0;
  for (int i = 0; i < 96; ++i) {
    const double turn = i * 2 * std::numbers::pi / 96;
    const std::vector<ContactPoint> inscribed = triangle_at(turn, 1);
    const std::vector<ContactPoint> within = triangle_at(turn, 0.95);
    most = std::max(most, PatchUnspanned(disc, n, inscribed));
    EXPECT_LE(most, LegalUnspanned(disc, n, inscribed) + 1e-12);
    EXPECT_GT(PatchUnspanned(disc, n, within), LegalUnspanned(disc, n, within));
  }
  EXPECT_NEAR(most, LegalUnspanned(disc, n, triangle_at(0, 1)), 1e-12);
}

TEST(PatchCoverage, OfADiscAllowsNoContactsDrawnInFromTheRim) {
  ContactPatch disc;
  disc.least_contacts = 3;
  std::vector<ContactPoint> half;
  for (int i = 0; i < 16; ++i) {
    const double angle = i * 2 * std::numbers::pi / 16;
    disc.vertices_W.emplace_back(std::cos(angle), std::sin(angle), 0);
    half.push_back({disc.vertices_W.back() / 2, -1e-3, {}});
  }
  const Eigen::Vector3d n = Eigen::Vector3d::UnitZ();
  EXPECT_GT(PatchUnspanned(disc, n, half), LegalUnspanned(disc, n, half));
}

TEST(PatchCoverage, OfASegmentNeedsBothEnds) {
  ContactPatch segment;
  segment.vertices_W = {{0.1, 0.2, 0.3}, {0.5, 0.1, 0.3}};
  const std::vector<ContactPoint> ends = {{{0.1, 0.2, 0.3}, -1e-3, {}},
                                          {{0.5, 0.1, 0.3}, -1e-3, {}}};
  const Eigen::Vector3d n = Eigen::Vector3d::UnitZ();
  EXPECT_LE(PatchUnspanned(segment, n, ends), kRounding);
  EXPECT_NEAR(PatchUnspanned(segment, n, std::span(ends).first(1)), 1, kRounding);
}

TEST(PatchBlur, IsWhatSidesMovedInwardsLeaveUnspanned) {
  // A face of 2 m by 1 cm, with all of its sides moved 1 mm inwards.
  ContactPatch patch;
  patch.vertices_W = {{1, 0.005, 0}, {-1, 0.005, 0}, {-1, -0.005, 0}, {1, -0.005, 0}};
  std::vector<ContactPoint> contacts;
  for (const Eigen::Vector3d& v : patch.vertices_W) {
    contacts.push_back({{v.x() * 0.999, v.y() * 0.8, 0}, -1e-3, {}});
  }
  const Eigen::Vector3d n = Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(PatchBlur(patch, n, 1e-3), 1e-3 / 0.005, 2e-3);
  EXPECT_LE(PatchUnspanned(patch, n, contacts), PatchBlur(patch, n, 1e-3));
}

TEST(PatchBlur, OfASegmentIsWhatBothItsEndsMayLose) {
  ContactPatch segment;
  segment.vertices_W = {{0, 0, 0}, {0, 2, 0}};
  EXPECT_DOUBLE_EQ(PatchBlur(segment, Eigen::Vector3d::UnitZ(), 1e-3), 1e-3);
}

TEST(ContactCount, IsRightWithTheFewestAndWithMore) {
  const Specimen s = BoxOnBoxFace(kDepth);
  std::vector<ContactPoint> contacts = s.right.points;
  EXPECT_EQ(ContactCountError(LowerFaceOf(s).least_contacts, contacts, kRounding), 0);
  contacts.push_back(contacts[0]);
  contacts.back().p_WC = (contacts[0].p_WC + contacts[1].p_WC) / 2;
  EXPECT_EQ(ContactCountError(LowerFaceOf(s).least_contacts, contacts, kRounding), 0);
}

TEST(ContactCount, SeesMissingContacts) {
  const Specimen s = BoxOnBoxFace(kDepth);
  EXPECT_EQ(ContactCountError(LowerFaceOf(s).least_contacts,
                              std::span(s.right.points).first(1), kRounding),
            3);
}

TEST(ContactCount, SeesRepeatedContacts) {
  const Specimen s = BoxOnBoxFace(kDepth);
  std::vector<ContactPoint> contacts = s.right.points;
  contacts.push_back(contacts[0]);
  contacts.push_back(contacts[2]);
  EXPECT_EQ(ContactCountError(LowerFaceOf(s).least_contacts, contacts, kRounding), 2);
}

}  // namespace
}  // namespace touchstone
