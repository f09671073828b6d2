#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/box_contacts.h"
#include "engine/feature.h"

// As in separating_axis.cc.
#define HWY_DISABLED_TARGETS                                                          \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/face_contacts.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "engine/four_lanes.h"

// The incident face, a parallelogram, is clipped to the reference face, a rectangle, all
// edges at once: corners of either lie in the other or not, and each edge of the incident
// face enters and leaves the rectangle at one place (Liang and Barsky, ACM TOG 3(1),
// 1984). One corner after the other (Sutherland and Hodgman) takes a dozen branches that
// nothing foretells.

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

/** The incident face as the reference face sees it: x and y along that face's edges from
 its centre, z outward from its plane. Its corners are centre ± side1 ± side2. [m] */
struct SeenFace {
  std::array<double, 3> centre;
  std::array<double, 3> side1;
  std::array<double, 3> side2;
  BoxFace reference;
  BoxFace incident;
  double h_x;  ///< Half sides of the reference face.
  double h_y;
  double h_outward;  ///< From the centre of the reference box to its face.
};

/** Returns the face of the other box that is most opposed to the reference face. */
HWY_INLINE SeenFace FindIncidentFace(const BoxPair& pair, const AxisGap& axis) {
  const bool is_B = axis.kind == AxisKind::kFaceOfB;
  const int both_axes[] = {axis.i, axis.j};
  const int reference = both_axes[is_B];
  const auto r = static_cast<std::size_t>(reference);
  const auto r1 = static_cast<std::size_t>(Next(reference));
  const auto r2 = static_cast<std::size_t>(AfterNext(reference));
  // Row k: axis k of the incident box.
  const std::array<Row, 3>* const both_R[] = {&pair.R_BA, &pair.R_AB};
  const Row* const both_t[] = {&pair.p_AB_A, &pair.p_AB_B};
  const Row* const both_h[] = {&pair.h_A, &pair.h_B};
  const std::array<Row, 3>& R = *both_R[is_B];
  const Row& t = *both_t[is_B];
  const Row& h_R = *both_h[is_B];
  const Row& h_I = *both_h[!is_B];
  const double towards = 1 - 2 * is_B;  // t, from A to B, turned to the incident box.
  const double outward = 1 - 2 * ((axis.offset < 0) != is_B);

  const double opposed[3] = {std::abs(R[0][r]), std::abs(R[1][r]), std::abs(R[2][r])};
  const std::size_t larger = opposed[1] > opposed[0];
  const std::size_t k =
      larger + (2 - larger) * static_cast<std::size_t>(opposed[2] > opposed[larger]);
  const std::size_t k1 = k == 2 ? 0 : k + 1;
  const std::size_t k2 = k == 0 ? 2 : k - 1;
  const double reach = -std::copysign(h_I[k], outward * R[k][r]);
  const auto side = [&](std::size_t n) HWY_ATTR {
    return std::array<double, 3>{h_I[n] * R[n][r1], h_I[n] * R[n][r2],
                                 outward * (h_I[n] * R[n][r])};
  };
  return {{towards * t[r1] + reach * R[k][r1], towards * t[r2] + reach * R[k][r2],
           outward * (towards * t[r] + reach * R[k][r]) - h_R[r]},
          side(k1),
          side(k2),
          {reference, outward > 0},
          {static_cast<int>(k), reach > 0},
          h_R[r1],
          h_R[r2],
          h_R[r]};
}

/** Where contacts may be: lanes 0…3 corners of the incident face, 4…7 where an edge of
 it, from that corner on, enters the rectangle, 8…11 where it leaves, 12…15 corners of the
 rectangle. */
struct Candidates {
  std::array<double, 16> x;
  std::array<double, 16> y;
  std::array<double, 16> z;
  std::array<std::int64_t, 16>
      line;         ///< One of the edges that meet; kOther has the other.
  unsigned kept;    ///< A bit for each.
  bool may_repeat;  ///< Two may be one and the same point, to rounding.
};

// The edges of the incident face that leave its corners, thrice, then those of the
// rectangle that bound it along x at its corners.
constexpr std::array<FaceEdge, 16> kOther = {3, 0, 2, 1, 3, 0, 2, 1,
                                             3, 0, 2, 1, 5, 4, 4, 5};
constexpr std::array<std::int64_t, 4> kArriving = {1, 3, 0, 2};
constexpr std::array<std::int64_t, 4> kAlongY = {7, 7, 6, 6};

HWY_INLINE void StoreBits(FourBits v, std::int64_t* p) {
  std::memcpy(p, &v, sizeof v);
}

HWY_INLINE std::int64_t Together(FourBits bits) {
  bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
  return bits[0] | bits[1];
}

HWY_INLINE void FindCandidates(const SeenFace& face, double slack, Candidates& found) {
  const auto& c = face.centre;
  const auto& u = face.side1;
  const auto& v = face.side2;
  const Four along_u{1, -1, -1, 1};
  const Four along_v{1, 1, -1, -1};
  const auto corners = [&](std::size_t k) HWY_ATTR {
    return Splat(c[k]) + along_u * Splat(u[k]) + along_v * Splat(v[k]);
  };
  const Four x = corners(0);
  const Four y = corners(1);
  const Four z = corners(2);
  const Four dx{-2 * u[0], -2 * v[0], 2 * u[0], 2 * v[0]};
  const Four dy{-2 * u[1], -2 * v[1], 2 * u[1], 2 * v[1]};
  const Four dz{-2 * u[2], -2 * v[2], 2 * u[2], 2 * v[2]};

  // Faces that lie flush share corners: rounding must not cut those off, so the lines
  // stand back by the slack, and what they let through is brought back to the face.
  const Four bound_x = Splat(face.h_x + slack);
  const Four bound_y = Splat(face.h_y + slack);
  const FourBits inside = (Abs(x) <= bound_x) & (Abs(y) <= bound_y);
  const FourBits next_inside = __builtin_shufflevector(inside, inside, 1, 2, 3, 0);

  // Shares of an edge at which it meets the lines; of parallel lines far off, not NaN.
  // 1e-300 times any box's distance from a line underflows to nothing; its inverse,
  // 1e300, is finite, so that no 0 · ∞ arises for a corner on the line.
  const Four least = Splat(1e-300);
  const Four one = Splat(1);
  const Four zero{};
  const Four per_x = one / Select(Abs(dx) < least, least, dx);
  const Four per_y = one / Select(Abs(dy) < least, least, dy);
  const Four x1 = (-bound_x - x) * per_x;
  const Four x2 = (bound_x - x) * per_x;
  const Four y1 = (-bound_y - y) * per_y;
  const Four y2 = (bound_y - y) * per_y;
  const Four enter_x = Min(x1, x2);
  const Four enter_y = Min(y1, y2);
  const Four leave_x = Max(x1, x2);
  const Four leave_y = Max(y1, y2);
  const Four enter = Min(Max(Max(enter_x, enter_y), zero), one);
  const Four leave = Max(Min(Min(leave_x, leave_y), one), zero);
  // Of an edge with an end inside only that end decides, as it does for its neighbour.
  const FourBits crosses = enter < leave;
  const FourBits enters = ~inside & (next_inside | crosses);
  const FourBits leaves = ~next_inside & (inside | crosses);
  const FourBits up_x = per_x > zero;
  const FourBits up_y = per_y > zero;
  StoreBits(enter_x > enter_y ? 5 + up_x : 7 + up_y, found.line.data() + 4);
  StoreBits(leave_x < leave_y ? 4 - up_x : 6 - up_y, found.line.data() + 8);
  std::copy(kArriving.begin(), kArriving.end(), found.line.begin());
  std::copy(kAlongY.begin(), kAlongY.end(), found.line.begin() + 12);

  // Corners of the rectangle in the parallelogram, to the same slack.
  const Four corner_x{face.h_x, -face.h_x, -face.h_x, face.h_x};
  const Four corner_y{face.h_y, face.h_y, -face.h_y, -face.h_y};
  const Four from_x = corner_x - Splat(c[0]);
  const Four from_y = corner_y - Splat(c[1]);
  const double area = u[0] * v[1] - u[1] * v[0];
  const Four share_u = from_x * Splat(v[1]) - from_y * Splat(v[0]);
  const Four share_v = from_y * Splat(u[0]) - from_x * Splat(u[1]);
  const Four beyond_u = Abs(share_u) - Splat(std::abs(area));
  const Four beyond_v = Abs(share_v) - Splat(std::abs(area));
  const Four slack_u = Splat(slack * (std::abs(v[0]) + std::abs(v[1])));
  const Four slack_v = Splat(slack * (std::abs(u[0]) + std::abs(u[1])));
  const FourBits covered = (beyond_u <= slack_u) & (beyond_v <= slack_v);
  const Four corner_z =
      Splat(c[2]) + (share_u * Splat(u[2]) + share_v * Splat(v[2])) / Splat(area);

  const Four enter_z = z + enter * dz;
  const Four leave_z = z + leave * dz;
  const Four none = Splat(std::numeric_limits<double>::infinity());
  const Four z0 = Select(inside, z, none);
  const Four z1 = Select(enters, enter_z, none);
  const Four z2 = Select(leaves, leave_z, none);
  const Four z3 = Select(covered, corner_z, none);
  const Four low = Min(Min(z0, z1), Min(z2, z3));
  const Four lower = Min(low, __builtin_shufflevector(low, low, 2, 3, 0, 1));
  const double least_z = std::min(lower[0], lower[1]);
  // The least is kept even where all lie above, and nothing where there is nothing.
  const Four highest = Splat(
      std::min(std::max(slack, least_z + slack), std::numeric_limits<double>::max()));
  found.kept = static_cast<unsigned>(
      Together(((z0 <= highest) & FourBits{1, 2, 4, 8}) |
               ((z1 <= highest) & FourBits{1 << 4, 1 << 5, 1 << 6, 1 << 7}) |
               ((z2 <= highest) & FourBits{1 << 8, 1 << 9, 1 << 10, 1 << 11}) |
               ((z3 <= highest) & FourBits{1 << 12, 1 << 13, 1 << 14, 1 << 15})));

  // Two candidates are one only where a corner of one face is near a line of the other:
  // they lie within 4 √2 slack of each other, and adjacent edges of the incident face,
  // seen along a normal at most 55° off, meet at no angle so flat that their corner is
  // more than thrice as far.
  const Four near = Splat(16 * slack);
  found.may_repeat =
      Together((Abs(Abs(x) - bound_x) <= near) | (Abs(Abs(y) - bound_y) <= near) |
               (Abs(beyond_u) <= Splat(16) * slack_u) |
               (Abs(beyond_v) <= Splat(16) * slack_v)) != 0;

  const auto put = [](std::array<double, 16>& lanes, Four l0, Four l1, Four l2, Four l3)
                       HWY_ATTR {
                         Store(l0, lanes.data());
                         Store(l1, lanes.data() + 4);
                         Store(l2, lanes.data() + 8);
                         Store(l3, lanes.data() + 12);
                       };
  put(found.x, x, x + enter * dx, x + leave * dx, corner_x);
  put(found.y, y, y + enter * dy, y + leave * dy, corner_y);
  put(found.z, z, enter_z, leave_z, corner_z);
}

/** Returns which candidates are kept of those that differ in x or y by more than
 `distance`. */
unsigned WithoutRepeats(const Candidates& found, double distance) {
  unsigned kept = 0;
  for (std::size_t k = 0; k < 16; ++k) {
    bool repeats = false;
    for (std::size_t n = 0; n < k; ++n) {
      repeats = repeats ||
                ((kept >> n & 1) != 0 && std::abs(found.x[k] - found.x[n]) <= distance &&
                 std::abs(found.y[k] - found.y[n]) <= distance);
    }
    if (!repeats) kept |= found.kept & 1u << k;
  }
  return kept;
}

void Fill(const BoxPair& pair, const AxisGap& axis, const Pose& X_WA, const Pose& X_WB,
          Manifold& manifold) {
  const SeenFace face = FindIncidentFace(pair, axis);
  const double slack = kOverlapRounding * pair.Size();
  Candidates found;
  FindCandidates(face, slack, found);
  if (found.kept == 0) {
    // Only where another axis is as good to within rounding can the faces miss each
    // other.
    const auto corners = found.z.begin();
    found.kept = 1u << (std::min_element(corners, corners + 4) - corners);
  }

  const bool reference_is_B = axis.kind == AxisKind::kFaceOfB;
  const Pose* const both_X[] = {&X_WA, &X_WB};
  const Pose& X_WR = *both_X[reference_is_B];
  const double* R = X_WR.R_WB.data();
  const double outward = 2 * face.reference.side - 1;
  const Four x_W = Load3(R + 3 * Next(face.reference.axis), 0);
  const Four y_W = Load3(R + 3 * AfterNext(face.reference.axis), 0);
  const Four z_W = Splat(outward) * Load3(R + 3 * face.reference.axis, 0);
  const Four p_WR = Load3(X_WR.p_WB.data(), 0);
  const auto put = [&](std::size_t k, ContactPoint& contact) HWY_ATTR {
    contact.separation = std::max(found.z[k], manifold.separation);
    contact.feature = FaceContactId(reference_is_B, face.reference, face.incident,
                                    kOther[k], static_cast<FaceEdge>(found.line[k]));
    const Four p_WC =
        p_WR + (Splat(std::min(std::max(found.x[k], -face.h_x), face.h_x)) * x_W +
                Splat(std::min(std::max(found.y[k], -face.h_y), face.h_y)) * y_W +
                Splat(face.h_outward + contact.separation / 2) * z_W);
    for (int n = 0; n < 3; ++n) contact.p_WC[n] = p_WC[n];
  };
  unsigned left = found.may_repeat ? WithoutRepeats(found, 4 * slack) : found.kept;
  manifold.count = std::min(std::popcount(left), 8);
  // Four in any case, of none if need be: how many there are cannot be foretold either.
  const int filled = std::max(manifold.count, 4);
  for (int n = 0; n < filled; ++n) {
    put(static_cast<std::size_t>(std::countr_zero(left)) % 16,
        manifold.contacts[static_cast<std::size_t>(n)]);
    left &= left - 1;
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(Fill);

void FillFaceContacts(const BoxPair& pair, const AxisGap& axis, const Pose& X_WA,
                      const Pose& X_WB, Manifold& manifold) {
  HWY_DYNAMIC_DISPATCH(Fill)(pair, axis, X_WA, X_WB, manifold);
}
}  // namespace cookbook
#endif
