#include "scenarios/generators/generate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/cube_rotations.h"
#include "scenarios/generators/placement.h"
#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/random_shape.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

constexpr std::array<std::string_view, 13> kNames = {
    "random",      "near_parallel",     "edge_edge",      "vertex_face", "touching",
    "deep",        "slabs_and_needles", "extreme_scales", "symmetries",  "grazing",
    "mixed_sizes", "far_from_origin",   "large_hulls"};

/** The kinds of A and B, and the source of random numbers for a query. */
struct Draw {
  ShapeKind a;
  ShapeKind b;
  Random& random;

  bool HasHalfSpace() const {
    return a == ShapeKind::kHalfSpace || b == ShapeKind::kHalfSpace;
  }
};

double LesserThickness(const Shape& a, const Shape& b) {
  return std::min(Thickness(a), Thickness(b));
}

/** Returns a gap of `lo` to `hi` times the lesser thickness, negative in two cases out of
 three. */
double RelativeGap(const Shape& a, const Shape& b, double lo, double hi, Random& random) {
  const double size = random.Uniform(lo, hi) * LesserThickness(a, b);
  return random.Below(3) < 2 ? -size : size;
}

FeatureKind AnyFeature(Random& random) {
  return static_cast<FeatureKind>(random.Below(3));
}

ContactQuery Against(const Body& A, FeatureKind of_A, const Shape& b, FeatureKind of_B,
                     double gap, Random& random) {
  const Feature on_A = RandomFeature(A.shape, of_A, random);
  const Feature on_B = RandomFeature(b, of_B, random);
  return {A, PlacedAgainst(A, on_A, b, on_B, gap, random)};
}

Body RandomBody(ShapeKind kind, Random& random) {
  const Shape shape = RandomShape(kind, random);
  return {shape, RandomPose(random)};
}

ContactQuery RandomQuestion(const Draw& draw) {
  Random& random = draw.random;
  const Body A = RandomBody(draw.a, random);
  const Shape b = RandomShape(draw.b, random);
  const Pose X_WB = RandomPose(random);
  const Vector3d n_W = DirectionOr(random.Direction(), A, b, X_WB);
  // Distance of the origins along n, as a fraction of the distance at which a plane
  // normal to n separates the two. A shape may lie deep inside a half-space, so fractions
  // below 0 are included there.
  const double share =
      draw.HasHalfSpace() ? random.Uniform(-0.5, 2) : random.Uniform(0, 5.0 / 3);
  const double height = DistanceAcrossPlane(A, b, X_WB, n_W);
  return {A, PlacedAlong(A, b, X_WB, n_W, (share - 1) * height, 0, random)};
}

ContactQuery NearParallel(const Draw& draw) {
  Random& random = draw.random;
  const Body A = RandomBody(draw.a, random);
  const Shape b = RandomShape(draw.b, random);
  const Vector3d any = random.Direction();
  const Vector3d axis =
      random.Below(3) == 0 ? Vector3d(Vector3d::Unit(random.Below(3))) : any;
  const Eigen::Quaterniond q_AB = RotationByHalfTangent(axis, random.Decades(-16, 0) / 2);
  const Pose X_WB = Pose::FromQuaternion(Vector3d::Zero(), Product(*A.X_WB.q_WB, q_AB));
  const Feature on_A = RandomFeature(
      A.shape, random.Coin() ? FeatureKind::kFace : FeatureKind::kEdge, random);
  const double gap = RelativeGap(A.shape, b, 0.001, 0.3, random);
  if (draw.HasHalfSpace()) {
    const Vector3d n_W = DirectionOr(Vector3d::Zero(), A, b, X_WB);
    return {A, PlacedAlong(A, b, X_WB, n_W, gap, random.Uniform(0, 3), random)};
  }
  return {A, PlacedOn(A, on_A, b, X_WB, gap)};
}

ContactQuery EdgeEdge(const Draw& draw) {
  const Body A = RandomBody(draw.a, draw.random);
  const Shape b = RandomShape(draw.b, draw.random);
  const double gap = RelativeGap(A.shape, b, 0.001, 0.2, draw.random);
  return Against(A, FeatureKind::kEdge, b, FeatureKind::kEdge, gap, draw.random);
}

ContactQuery VertexFace(const Draw& draw) {
  const Body A = RandomBody(draw.a, draw.random);
  const Shape b = RandomShape(draw.b, draw.random);
  const double gap = RelativeGap(A.shape, b, 0.001, 0.2, draw.random);
  const bool coin = draw.random.Coin();
  // A half-space has only a face, so the vertex is that of the other shape.
  const bool vertex_is_A = draw.HasHalfSpace() ? draw.b == ShapeKind::kHalfSpace : coin;
  return vertex_is_A
             ? Against(A, FeatureKind::kVertex, b, FeatureKind::kFace, gap, draw.random)
             : Against(A, FeatureKind::kFace, b, FeatureKind::kVertex, gap, draw.random);
}

ContactQuery TouchingQuestion(const Draw& draw) {
  Random& random = draw.random;
  const Body A = RandomBody(draw.a, random);
  const Shape b = RandomShape(draw.b, random);
  const double sign = random.Sign();
  const double gap = sign * random.Decades(-14, -1);
  const FeatureKind of_A = AnyFeature(random);
  const FeatureKind of_B = AnyFeature(random);
  return Against(A, of_A, b, of_B, gap, random);
}

ContactQuery Deep(const Draw& draw) {
  Random& random = draw.random;
  const Body A = RandomBody(draw.a, random);
  const double smaller = random.Uniform(0.05, 0.3);
  const Shape shape = RandomShape(draw.b, random);
  const Shape b = random.Below(3) == 0 ? Resized(shape, smaller) : shape;
  Body B{b, RandomPose(random)};
  const Vector3d n_W = DirectionOr(random.Direction(), A, b, B.X_WB);
  const double share = random.Below(6) == 0 ? 0 : random.Uniform(0, 0.9);
  if (draw.HasHalfSpace()) {
    // The shape is immersed by up to four of its radii beyond full immersion.
    const double radius = BoundingRadius(A.shape) + BoundingRadius(b);
    B.X_WB.p_WB = A.X_WB.p_WB - (1 + 4 * share) * radius * n_W;
  } else {
    B.X_WB.p_WB = A.X_WB.p_WB + share * InnerRadius(A.shape) * n_W;
  }
  return {A, B};
}

ContactQuery SlabsAndNeedles(const Draw& draw) {
  Random& random = draw.random;
  const Shape a = RandomThinShape(draw.a, random);
  const Body A{a, RandomPose(random)};
  const Shape b = RandomThinShape(draw.b, random);
  const double gap = RelativeGap(a, b, 0.01, 0.5, random);
  const FeatureKind of_A = AnyFeature(random);
  const FeatureKind of_B = AnyFeature(random);
  return Against(A, of_A, b, of_B, gap, random);
}

ContactQuery ExtremeScales(const Draw& draw) {
  Random& random = draw.random;
  const double scale_a = random.Decades(-3, 3);
  const double other_scale = random.Decades(-3, 3);
  const double scale_b = random.Coin() ? scale_a : other_scale;
  const Shape a = Resized(RandomShape(draw.a, random), scale_a);
  const Shape b = Resized(RandomShape(draw.b, random), scale_b);
  Body A{a, RandomPose(random)};
  const Vector3d away = random.Direction();
  const double distance = random.Decades(0, 5);
  A.X_WB.p_WB =
      random.Coin() ? Vector3d(distance * away) : Vector3d(scale_a * A.X_WB.p_WB);
  const double gap = RelativeGap(a, b, 0.01, 0.5, random);
  const FeatureKind of_A = AnyFeature(random);
  const FeatureKind of_B = AnyFeature(random);
  return Against(A, of_A, b, of_B, gap, random);
}

/** Returns the tangent of half the angle of a rung. The angles are 10^-15, 10^-14, …,
 10^-1 rad (up to a twelfth of the angle's cube), and π/4, since tan π/8 = √2 − 1. */
double HalfTangentOfRung(int rung) {
  constexpr std::array<double, 15> kAngles = {1e-15, 1e-14, 1e-13, 1e-12, 1e-11,
                                              1e-10, 1e-9,  1e-8,  1e-7,  1e-6,
                                              1e-5,  1e-4,  1e-3,  1e-2,  1e-1};
  if (rung == 15) return std::sqrt(2.0) - 1;
  return kAngles[static_cast<std::size_t>(rung)] / 2;
}

ContactQuery Symmetries(const Draw& draw, std::uint64_t index) {
  Random& random = draw.random;
  Body A = RandomBody(draw.a, random);
  if (random.Coin()) {
    A.X_WB = Pose::FromMatrix(A.X_WB.p_WB, Eigen::Matrix3d::Identity());
  }
  const Shape other = RandomShape(draw.b, random);
  const Shape b = draw.a == draw.b && random.Coin() ? A.shape : other;
  const Eigen::Matrix3d symmetry = CubeRotation(static_cast<int>(index % kCubeRotations));
  const auto rung = static_cast<int>(index / kCubeRotations % 16);
  const Eigen::Matrix3d perturbation =
      RotationByHalfTangent(random.Direction(), HalfTangentOfRung(rung))
          .toRotationMatrix();
  const Pose X_WB = Pose::FromMatrix(
      Vector3d::Zero(), Product(A.X_WB.R_WB, Product(symmetry, perturbation)));
  const double sign = random.Sign();
  const Vector3d axis_W = sign * A.X_WB.R_WB.col(random.Below(3));
  const Vector3d n_W = DirectionOr(axis_W, A, b, X_WB);
  const double sideways = random.Uniform(0, 0.5) * LesserThickness(A.shape, b);
  const double shift = random.Coin() ? 0 : sideways;
  const double gap = RelativeGap(A.shape, b, 0.01, 0.5, random);
  return {A, PlacedAlong(A, b, X_WB, n_W, gap, shift, random)};
}

ContactQuery Grazing(const Draw& draw) {
  Random& random = draw.random;
  const Body A = RandomBody(draw.a, random);
  const Shape b = RandomShape(draw.b, random);
  const double sign = random.Sign();
  const double gap = sign * std::ldexp(1.0, -52 + random.Below(13));
  const FeatureKind of_A = AnyFeature(random);
  const FeatureKind of_B = AnyFeature(random);
  return Against(A, of_A, b, of_B, gap, random);
}

ContactQuery MixedSizes(const Draw& draw) {
  Random& random = draw.random;
  const double smaller = random.Decades(-6, 0);
  const bool is_A = random.Coin();
  const Shape a = RandomShape(draw.a, random);
  const Body A{is_A ? Resized(a, smaller) : a, RandomPose(random)};
  const Shape other = RandomShape(draw.b, random);
  const Shape b = is_A ? other : Resized(other, smaller);
  const double gap = RelativeGap(A.shape, b, 0.01, 0.5, random);
  const FeatureKind of_A = AnyFeature(random);
  const FeatureKind of_B = AnyFeature(random);
  return Against(A, of_A, b, of_B, gap, random);
}

ContactQuery FarFromOrigin(const Draw& draw) {
  Random& random = draw.random;
  Body A = RandomBody(draw.a, random);
  const double distance = random.Decades(2, 7);
  A.X_WB.p_WB = distance * random.Direction();
  const Shape b = RandomShape(draw.b, random);
  const double gap = RelativeGap(A.shape, b, 0.01, 0.5, random);
  const FeatureKind of_A = AnyFeature(random);
  const FeatureKind of_B = AnyFeature(random);
  return Against(A, of_A, b, of_B, gap, random);
}

ContactQuery LargeHulls(const Draw& draw) {
  Random& random = draw.random;
  const Shape a = RandomLargeShape(draw.a, random);
  const Body A{a, RandomPose(random)};
  const Shape b = RandomLargeShape(draw.b, random);
  const Pose X_WB = RandomPose(random);
  // Every size is at least 0.2 m, and a hull contains a ball of 0.04 m.
  const double size = random.Uniform(0.001, 0.1);
  const double gap = random.Below(3) < 2 ? -size : size;
  const Vector3d n_A = random.Direction();
  if (draw.HasHalfSpace()) {
    const Vector3d n_W = DirectionOr(Vector3d::Zero(), A, b, X_WB);
    return {A, PlacedAlong(A, b, X_WB, n_W, gap, 0, random)};
  }
  return {A, PlacedOn(A, {SupportPoint(A.shape, n_A), n_A}, b, X_WB, gap)};
}

}  // namespace

std::vector<Family> AllFamilies() {
  std::vector<Family> families;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    families.push_back(static_cast<Family>(i));
  }
  return families;
}

std::string_view NameOf(Family family) {
  return kNames[static_cast<std::size_t>(family)];
}

std::optional<Family> FamilyNamed(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Family>(found - kNames.begin());
}

ContactQuery Generate(Family family, ShapeKind a, ShapeKind b, std::uint64_t seed,
                      std::uint64_t index) {
  Random random({seed, index, static_cast<std::uint64_t>(family),
                 static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b)});
  const Draw draw{a, b, random};
  switch (family) {
    case Family::kRandom:
      return RandomQuestion(draw);
    case Family::kNearParallel:
      return NearParallel(draw);
    case Family::kEdgeEdge:
      return EdgeEdge(draw);
    case Family::kVertexFace:
      return VertexFace(draw);
    case Family::kTouching:
      return TouchingQuestion(draw);
    case Family::kDeep:
      return Deep(draw);
    case Family::kSlabsAndNeedles:
      return SlabsAndNeedles(draw);
    case Family::kExtremeScales:
      return ExtremeScales(draw);
    case Family::kSymmetries:
      return Symmetries(draw, index);
    case Family::kGrazing:
      return Grazing(draw);
    case Family::kMixedSizes:
      return MixedSizes(draw);
    case Family::kFarFromOrigin:
      return FarFromOrigin(draw);
    case Family::kLargeHulls:
      return LargeHulls(draw);
  }
  return {};
}

}  // namespace touchstone
