#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/collision/collide.h"
#include "engine/collision/feature.h"
#include "engine/collision/rounding.h"

#define COOKBOOK_DISABLED_TARGETS (COOKBOOK_SIZELESS_TARGETS | COOKBOOK_NARROW_TARGETS)
#define HWY_TARGET_INCLUDE "engine/collision/box_sphere.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

/** A table of SphereContactId(). The lower three bits of the index mark the axes along
 which the centre is outside the box, the upper three those with a negative coordinate. */
constexpr std::array<std::uint8_t, 64> kFeatures = [] {
  std::array<std::uint8_t, 64> features{};
  for (unsigned bits = 0; bits < features.size(); ++bits) {
    const auto side = [bits](unsigned axis) {
      if ((bits >> axis & 1) == 0) return 0;
      return (bits >> (3 + axis) & 1) != 0 ? -1 : 1;
    };
    features[bits] =
        static_cast<std::uint8_t>(SphereContactId(side(0), side(1), side(2)));
  }
  return features;
}();

void CollideBoxSphere(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
                      Manifold& manifold) {
  Four axes[3];        // Lane c of [i]: component c of axis i.
  Four components[3];  // Lane i of [c].
  LoadColumns(X_WA.R_WB.data(), axes);
  Transpose(axes, components);
  const Four p_WB = Load3(X_WB.p_WB.data(), 0);
  const Four d = p_WB - Load3(X_WA.p_WB.data(), 0);
  const Four p = components[0] * Splat(d[0]) + components[1] * Splat(d[1]) +
                 components[2] * Splat(d[2]);

  // n points from the nearest point of the box to the centre. The fourth lane stays 0.
  const Four h = Load3(A.half_extents.data(), 0);
  Four n = p - Min(Max(p, -h), h);
  unsigned outside = Bits(Abs(p) > h);
  const unsigned negative = Bits(p < Four{});
  const Four squares = n * n;
  const double squared_distance = squares[0] + squares[1] + squares[2];
  double distance;
  double scale;
  if (squared_distance < kLeastSquaredLength) [[unlikely]] {
    // The centre is inside or on the surface: the normal leaves by the nearest face.
    const Four inside = h - Abs(p);
    const double least = std::min(inside[0], inside[1]);
    const unsigned axis = inside[2] < least ? 2 : inside[1] < inside[0];
    const double side = (negative >> axis & 1) != 0 ? -1 : 1;
    n = Four{axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0, 0};
    outside = 1u << axis;
    distance = -std::min(least, inside[2]);
    scale = 1;
  } else {
    distance = std::sqrt(squared_distance);
    scale = 1 / distance;
  }

  const double separation = distance - B.radius;
  const Four n_W =
      (axes[0] * Splat(n[0]) + axes[1] * Splat(n[1]) + axes[2] * Splat(n[2])) *
      Splat(scale);
  // Filled even if apart: an unpredictable branch costs more than the contact.
  const Four p_WC = p_WB - Splat(B.radius + separation / 2) * n_W;
  const FourBits last{0, 0, 0, -1};
  static_assert(offsetof(Manifold, separation) ==
                offsetof(Manifold, n_AB_W) + sizeof(Eigen::Vector3d));
  static_assert(offsetof(ContactPoint, separation) == sizeof(Eigen::Vector3d));
  ContactPoint& contact = manifold.contacts[0];
  Store(Select(last, Splat(separation), n_W), &manifold.n_AB_W);
  Store(Select(last, Splat(separation), p_WC), &contact);
  contact.feature = kFeatures[outside | negative << 3];
  manifold.touching = separation <= 0;
  manifold.count = manifold.touching;
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
void Collide(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
             Manifold& manifold) {
  COOKBOOK_DISPATCH(CollideBoxSphere)(A, X_WA, B, X_WB, manifold);
}

void Collide(const Sphere& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
             Manifold& manifold) {
  Collide(B, X_WB, A, X_WA, manifold);
  manifold.n_AB_W = -manifold.n_AB_W;
}
}  // namespace cookbook
#endif
