#include "scenarios/generators/feature.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "scenarios/generators/hull_facets.h"
#include "scenarios/generators/random_shape.h"

namespace touchstone {
namespace {

class OfEveryKind : public ::testing::TestWithParam<int> {
 protected:
  ShapeKind kind() const { return static_cast<ShapeKind>(GetParam()); }
};

TEST_P(OfEveryKind, NoPointOfTheShapeIsBeyondAFeature) {
  // The support height is computed in two ways: from the feature, and by SupportPoint().
  Random random({3, static_cast<std::uint64_t>(GetParam())});
  for (int i = 0; i < 1000; ++i) {
    const Shape shape = RandomShape(kind(), random);
    const auto feature_kind = static_cast<FeatureKind>(i % 3);
    const Feature feature = RandomFeature(shape, feature_kind, random);
    EXPECT_NEAR(feature.n_B.norm(), 1, 1e-15);
    // Points are within 3 m of the origin, so the error is a few roundings of 3 * 2^-53.
    EXPECT_NEAR(feature.n_B.dot(SupportPoint(shape, feature.n_B)),
                feature.n_B.dot(feature.p_B), 2e-15);
  }
}

TEST_P(OfEveryKind, ThinShapesAreThinByUpToFourDecades) {
  if (kind() == ShapeKind::kHalfSpace) return;  // has no size
  Random random({4, static_cast<std::uint64_t>(GetParam())});
  double thinnest = 1;
  for (int i = 0; i < 300; ++i) {
    const double thickness = Thickness(RandomThinShape(kind(), random));
    EXPECT_LE(thickness, 0.12);  // a tenth of the longest length
    thinnest = std::min(thinnest, thickness);
  }
  EXPECT_LT(thinnest, 1e-3);
  EXPECT_GE(thinnest,
            2e-5 * 0.21);  // see RandomHull(): a hull contains 0.21 of its ellipsoid
}

TEST_P(OfEveryKind, ResizingScalesEverySize) {
  Random random({5, static_cast<std::uint64_t>(GetParam())});
  const Shape shape = RandomShape(kind(), random);
  if (kind() == ShapeKind::kHalfSpace) return;  // has no size
  // A power of two scales without rounding.
  EXPECT_EQ(Thickness(Resized(shape, 0.25)), 0.25 * Thickness(shape));
  EXPECT_EQ(BoundingRadius(Resized(shape, 0.25)), 0.25 * BoundingRadius(shape));
}

INSTANTIATE_TEST_SUITE_P(Shapes, OfEveryKind, ::testing::Range(0, kShapeKinds),
                         [](const auto& kind) {
                           return std::string(NameOf(static_cast<ShapeKind>(kind.param)));
                         });

TEST(RandomHull, HasOnlyCornersAndContainsABallAboutItsOrigin) {
  Random random({6});
  for (int i = 0; i < 1000; ++i) {
    const auto hull = std::get<ConvexHull>(RandomShape(ShapeKind::kConvexHull, random));
    EXPECT_GE(InnerRadius(hull), 0.04);
    const std::vector<Facet> facets = FacetsOf(hull);
    // Euler: a triangulated sphere of v vertices has 2 v − 4 triangles.
    EXPECT_EQ(facets.size(), 2 * hull.vertices.size() - 4);
    for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
      EXPECT_TRUE(std::any_of(facets.begin(), facets.end(), [v](const Facet& facet) {
        return std::find(facet.vertices.begin(), facet.vertices.end(), v) !=
               facet.vertices.end();
      }));
    }
  }
}

TEST(InnerRadiusOfACone, IsTheDistanceToItsNearestSurface) {
  // Slant 3-4-5: r = 3, height 2 h = 4. The lateral line from (0, 2) to (3, −2) is at
  // 3 · 2 / 5 = 1.2 from the origin, nearer than the base at 2.
  EXPECT_DOUBLE_EQ(InnerRadius(Cone{3, 2}), 1.2);
  EXPECT_DOUBLE_EQ(InnerRadius(Cone{30, 0.5}), 0.5 * 30 / std::sqrt(901.0));
}

}  // namespace
}  // namespace touchstone
