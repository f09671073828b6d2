// The contacts of two boxes, compiled once per SIMD target. Include it after
// engine/simd/four_lanes.h, in a file that foreach_target.h includes repeatedly; hence
// the include guard that toggles.
//
// Contacts lie between one face of each box, projected along the normal: the reference
// face, from which the normal leans least, and the incident face, the face of the other
// box that is most opposed to the normal. Along a face normal these are the usual
// reference and incident faces (Gaul). Along the cross product of two edges, the
// reference face is A's and the two edges bound the two faces. The point where the edges
// cross is a corner of the faces' intersection: the deepest corner, and the only one
// below zero if the faces slope away from it. If they hardly slope, the edge pair was
// best by a hair, and the corners of a face that lies flush must not be lost because of
// that.
//
// One routine therefore serves both cases. The incident face, a parallelogram, is clipped
// to the reference face, a rectangle, with all edges at once: each corner of either face
// lies inside the other or not, and each edge of the incident face enters the rectangle
// at one point and leaves it at one (Liang and Barsky, ACM TOG 3(1), 1984). Clipping
// corner by corner (Sutherland and Hodgman) takes a dozen unpredictable branches.

#if defined(COOKBOOK_ENGINE_ONE_PAIR_CONTACTS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_ONE_PAIR_CONTACTS_H_
#undef COOKBOOK_ENGINE_ONE_PAIR_CONTACTS_H_
#else
#define COOKBOOK_ENGINE_ONE_PAIR_CONTACTS_H_
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/collision/feature.h"
#include "engine/collision/manifold.h"
#include "engine/collision/one_pair_axis.h"
#include "engine/collision/rounding.h"
#include "engine/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {

/** The incident face, projected along the normal onto the plane of the reference face. x
 and y locate the projected point along the reference face's edges, from its centre; z is
 the gap along the normal. The corners are centre ± side1 ± side2. [m] */
struct SeenFace {
  Four centre[3];  ///< x, y and z, each in all lanes.
  Four side1[3];
  Four side2[3];
  BoxFace reference;
  BoxFace incident;
  double h_x;        ///< Half side of the reference face along x. [m]
  double h_y;        ///< Half side along y. [m]
  double h_outward;  ///< From the centre of the reference box to the face. [m]
};

/** Returns the incident face: the face of the other box that is most opposed to the
 normal. */
HWY_INLINE SeenFace FindIncidentFace(const BoxPair& pair, const Facing& facing) {
  const std::size_t is_B = facing.is_B;
  const auto r = static_cast<std::size_t>(facing.axis);
  const auto r1 = static_cast<std::size_t>(Next(facing.axis));
  const auto r2 = static_cast<std::size_t>(AfterNext(facing.axis));
  const auto lean = static_cast<std::size_t>(facing.lean);
  // Row k of `axes`: axis k of the incident box.
  const std::array<Row, 3>& axes = pair.R[1 - is_B];
  const std::array<Row, 3>& components = pair.R[is_B];
  const Row& t = pair.p_AB[is_B];
  const Row& h_R = pair.h[is_B];
  const Row& h_I = pair.h[1 - is_B];

  // From here on everything is relative to the reference box, whether A or B: t, which
  // points from A to B, and the normal are flipped to point to the incident box.
  const double towards = 1 - 2 * facing.is_B;
  const double n_axis = towards * facing.n_axis;
  const double n_lean = towards * facing.n_lean;
  const double outward = std::copysign(1.0, n_axis);

  alignas(32) Row n_I;
  const Four n = Splat(n_axis) * Load(components[r].data()) +
                 Splat(n_lean) * Load(components[lean].data());
  Store(n, n_I.data());
  const std::size_t k = FirstGreatest(Abs(n));
  const auto k1 = static_cast<std::size_t>(Next(static_cast<int>(k)));
  const auto k2 = static_cast<std::size_t>(AfterNext(static_cast<int>(k)));
  const double reach = -std::copysign(h_I[k], n_I[k]);

  // A point at height z above the plane is projected along the normal, which shifts it
  // sideways by z n_lean / n_axis.
  const double steepness = 1 / std::abs(n_axis);
  const double aside = n_lean * steepness;
  constexpr std::array<double, 2> kIs = {0, 1};  // Converts a bool without a branch.
  const Four aside_x = Splat(kIs[lean == r1] * aside);
  const Four aside_y = Splat(kIs[lean == r2] * aside);
  const auto see = [&](Four p_r, Four p_r1, Four p_r2, Four plane, Four out[3]) HWY_ATTR {
    const Four z = Splat(outward) * p_r - plane;
    out[0] = p_r1 - z * aside_x;
    out[1] = p_r2 - z * aside_y;
    out[2] = z * Splat(steepness);
  };
  SeenFace face;
  const auto centre = [&](std::size_t c) HWY_ATTR {
    return Splat(towards) * Splat(t[c]) + Splat(reach) * Splat(axes[k][c]);
  };
  see(centre(r), centre(r1), centre(r2), Splat(h_R[r]), face.centre);
  const auto side = [&](std::size_t axis, Four out[3]) HWY_ATTR {
    const auto along = [&](std::size_t c)
                           HWY_ATTR { return Splat(h_I[axis]) * Splat(axes[axis][c]); };
    see(along(r), along(r1), along(r2), Four{}, out);
  };
  side(k1, face.side1);
  side(k2, face.side2);
  face.reference = {facing.axis, outward > 0};
  face.incident = {static_cast<int>(k), reach > 0};
  face.h_x = h_R[r1];
  face.h_y = h_R[r2];
  face.h_outward = h_R[r];
  return face;
}

/** The candidates for contacts. Lanes 0…3: the points where the edges of the incident
 face enter the rectangle, or an edge's first corner if that is inside. Lanes 4…7: the
 points where they leave it. Lanes 8…11: the corners of the rectangle. */
struct alignas(32) Corners {
  std::array<double, 12> x;
  std::array<double, 12> y;
  std::array<double, 12> z;
  std::array<std::int64_t, 12> feature;
  unsigned kept;    ///< Bit k is set if candidate k is kept.
  bool may_repeat;  ///< Whether two may be the same point, to rounding.
};

HWY_INLINE void StoreBits(FourBits v, std::int64_t* p) {
  std::memcpy(p, &v, sizeof v);
}

/** Finds the candidates. Those at or below zero are kept, to rounding; if all are above,
 the lowest is kept. */
HWY_INLINE void FindCorners(const SeenFace& face, double tolerance, double separation,
                            std::int64_t faces, Corners& found) {
  const auto& c = face.centre;
  const auto& u = face.side1;
  const auto& v = face.side2;
  const Four along_u{1, -1, -1, 1};
  const Four along_v{1, 1, -1, -1};
  const Four along_edge{-2, -2, 2, 2};
  const auto corners = [&](std::size_t k)
                           HWY_ATTR { return c[k] + along_u * u[k] + along_v * v[k]; };
  const auto edges = [&](std::size_t k) HWY_ATTR {
    return __builtin_shufflevector(u[k], v[k], 0, 5, 2, 7) * along_edge;
  };
  const Four x = corners(0);
  const Four y = corners(1);
  const Four z = corners(2);
  const Four dx = edges(0);
  const Four dy = edges(1);
  const Four dz = edges(2);

  // Faces that lie flush share corners, which rounding must not cut off. The clip lines
  // are therefore moved out by `tolerance`, and the points that pass are clamped to the
  // face.
  const Four bound_x = Splat(face.h_x + tolerance);
  const Four bound_y = Splat(face.h_y + tolerance);
  const FourBits inside = (Abs(x) <= bound_x) & (Abs(y) <= bound_y);
  const FourBits next_inside = __builtin_shufflevector(inside, inside, 1, 2, 3, 0);

  // Fractions of an edge at which it meets the clip lines. For an edge parallel to a line
  // they are 0 or far outside [0, 1], never NaN: 1e-300 is negligible next to the
  // distance of any box from a line, and its inverse, 1e300, is finite, so that no 0 · ∞
  // arises for a corner on the line.
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
  // For a corner inside, both are at most 0 and `enter` is 0: the corner itself.
  const Four enter = Min(Max(Max(enter_x, enter_y), zero), one);
  const Four leave = Max(Min(Min(leave_x, leave_y), one), zero);
  // If an end of an edge is inside, that end alone decides, as it does for the neighbour.
  const FourBits crosses = enter < leave;
  const FourBits enters = inside | next_inside | crosses;
  const FourBits leaves = ~next_inside & (inside | crosses);

  // Features. A corner is named after the two edges of the incident face that meet in it,
  // a crossing after the edge and the line that it crosses.
  constexpr FaceEdge kEdge[] = {3, 0, 2, 1};
  const FourBits corner_feature{EdgesId(1, 3), EdgesId(3, 0), EdgesId(0, 2),
                                EdgesId(2, 1)};
  const FourBits edge_feature{kEdge[0] << 3, kEdge[1] << 3, kEdge[2] << 3, kEdge[3] << 3};
  const FourBits up_x = per_x > zero;
  const FourBits up_y = per_y > zero;
  const FourBits enter_line = enter_x > enter_y ? 5 + up_x : 7 + up_y;
  const FourBits leave_line = leave_x < leave_y ? 4 - up_x : 6 - up_y;
  StoreBits((inside ? corner_feature : edge_feature + enter_line) + faces,
            found.feature.data());
  StoreBits(edge_feature + leave_line + faces, found.feature.data() + 4);
  StoreBits(FourBits{EdgesId(5, 7), EdgesId(4, 7), EdgesId(4, 6), EdgesId(5, 6)} + faces,
            found.feature.data() + 8);

  // Corners of the rectangle that lie in the parallelogram, to within the same tolerance.
  const Four corner_x = Splat(face.h_x) * Four{1, -1, -1, 1};
  const Four corner_y = Splat(face.h_y) * Four{1, 1, -1, -1};
  const Four from_x = corner_x - c[0];
  const Four from_y = corner_y - c[1];
  const Four area = u[0] * v[1] - u[1] * v[0];
  const Four share_u = from_x * v[1] - from_y * v[0];
  const Four share_v = from_y * u[0] - from_x * u[1];
  const Four beyond_u = Abs(share_u) - Abs(area);
  const Four beyond_v = Abs(share_v) - Abs(area);
  const Four tolerance_u = Splat(tolerance) * (Abs(v[0]) + Abs(v[1]));
  const Four tolerance_v = Splat(tolerance) * (Abs(u[0]) + Abs(u[1]));
  const FourBits covered = (beyond_u <= tolerance_u) & (beyond_v <= tolerance_v);

  const Four enter_z = z + enter * dz;
  const Four leave_z = z + leave * dz;
  const Four corner_z = c[2] + (share_u * u[2] + share_v * v[2]) / area;
  Four highest = Splat(tolerance);
  const FourBits deep = ((enter_z <= zero) & enters) | ((leave_z <= zero) & leaves) |
                        ((corner_z <= zero) & covered);
  if (Bits(deep) == 0) [[unlikely]] {
    // The lowest is kept even if all lie above; none is kept if there is none.
    const Four none = Splat(std::numeric_limits<double>::infinity());
    const Four low =
        Min(Min(Select(enters, enter_z, none), Select(leaves, leave_z, none)),
            Select(covered, corner_z, none));
    const Four lower = Min(low, __builtin_shufflevector(low, low, 2, 3, 0, 1));
    highest =
        Splat(std::min(std::max(tolerance, std::min(lower[0], lower[1]) + tolerance),
                       std::numeric_limits<double>::max()));
  }
  found.kept = Bits((enter_z <= highest) & enters) |
               Bits((leave_z <= highest) & leaves) << 4 |
               Bits((corner_z <= highest) & covered) << 8;

  // Two candidates can be one point only if a corner of one face is near a line of the
  // other. They then lie within √2 kSameCorner tolerance of each other. Adjacent edges of
  // the incident face, projected along a normal at most 55° off, never meet at so flat an
  // angle that their corner is more than three times as far.
  const Four near = Splat(4 * kSameCorner * tolerance);
  found.may_repeat =
      Bits((Abs(Abs(x) - bound_x) <= near) | (Abs(Abs(y) - bound_y) <= near) |
           (Abs(beyond_u) <= Splat(4 * kSameCorner) * tolerance_u) |
           (Abs(beyond_v) <= Splat(4 * kSameCorner) * tolerance_v)) != 0;

  const Four h_x = Splat(face.h_x);
  const Four h_y = Splat(face.h_y);
  Store(Min(Max(x + enter * dx, -h_x), h_x), found.x.data());
  Store(Min(Max(x + leave * dx, -h_x), h_x), found.x.data() + 4);
  Store(corner_x, found.x.data() + 8);
  Store(Min(Max(y + enter * dy, -h_y), h_y), found.y.data());
  Store(Min(Max(y + leave * dy, -h_y), h_y), found.y.data() + 4);
  Store(corner_y, found.y.data() + 8);
  const Four deepest = Splat(separation);
  Store(Max(enter_z, deepest), found.z.data());
  Store(Max(leave_z, deepest), found.z.data() + 4);
  Store(Max(corner_z, deepest), found.z.data() + 8);
}

/** Returns the kept candidates without repeats: those that differ in x or y by more than
 kSameCorner · tolerance. The first of several repeats is kept, but moved to the deepest
 if that is deeper by more than `tolerance`: along a steep edge, a negligible distance
 makes many roundings of depth. */
inline unsigned WithoutRepeats(Corners& found, double tolerance) {
  const double distance = kSameCorner * tolerance;
  unsigned kept = 0;
  for (std::size_t k = 0; k < found.x.size(); ++k) {
    if ((found.kept >> k & 1) == 0) continue;
    bool repeats = false;
    for (std::size_t n = 0; n < k && !repeats; ++n) {
      repeats = (kept >> n & 1) != 0 && std::abs(found.x[k] - found.x[n]) <= distance &&
                std::abs(found.y[k] - found.y[n]) <= distance;
      if (repeats && found.z[k] < found.z[n] - tolerance) {
        found.x[n] = found.x[k];
        found.y[n] = found.y[k];
        found.z[n] = found.z[k];
      }
    }
    if (!repeats) kept |= 1u << k;
  }
  return kept;
}

/** Fills in the contacts of two boxes along the normal of `facing`: at least one. */
HWY_INLINE void FillContacts(const BoxPair& pair, const Facing& facing, const Pose& X_WA,
                             const Pose& X_WB, Manifold& manifold) {
  const SeenFace face = FindIncidentFace(pair, facing);
  const double tolerance = kFlush * pair.size;
  Corners found;
  FindCorners(face, tolerance, manifold.separation,
              FaceContactId(facing.is_B, face.reference, face.incident, 0, 0), found);
  if (found.kept == 0) {
    // The faces can miss each other only if another axis is as good to within rounding.
    found.kept =
        1u << (std::min_element(found.z.begin(), found.z.begin() + 4) - found.z.begin());
  }
  const unsigned distinct =
      found.may_repeat ? WithoutRepeats(found, tolerance) : found.kept;
  manifold.count = std::min(std::popcount(distinct), 8);

  const std::array<const Pose*, 2> both_X = {&X_WA, &X_WB};
  const Pose& X_WR = *both_X[facing.is_B];
  const auto axis_W = [&X_WR](int i)
                          HWY_ATTR { return Load3(X_WR.R_WB.col(i).data(), 0); };
  const double outward = 2 * face.reference.side - 1;
  // p_WC and separation of a contact are computed at once: lane 3 is the separation.
  const Four x_W = axis_W(Next(facing.axis));
  const Four y_W = axis_W(AfterNext(facing.axis));
  const Four p_W =
      Load3(X_WR.p_WB.data(), 0) + Splat(outward * face.h_outward) * axis_W(facing.axis);
  const double towards = 0.5 * (1 - 2 * facing.is_B);
  const Four half_n_W{towards * manifold.n_AB_W[0], towards * manifold.n_AB_W[1],
                      towards * manifold.n_AB_W[2], 1};
  static_assert(offsetof(ContactPoint, separation) == sizeof(Eigen::Vector3d));
  unsigned left = distinct;
  const auto put = [&](std::size_t n) HWY_ATTR {
    const auto k = static_cast<std::size_t>(std::countr_zero(left | 1u << 11));
    const Four contact = p_W + (Splat(found.x[k]) * x_W + Splat(found.y[k]) * y_W +
                                Splat(found.z[k]) * half_n_W);
    std::memcpy(reinterpret_cast<char*>(&manifold.contacts[n]), &contact, sizeof contact);
    manifold.contacts[n].feature = static_cast<FeatureId>(found.feature[k]);
    left &= left - 1;
  };
  // Four are always written, even if there are fewer: their number is unpredictable. More
  // than four are rare enough (three in ten random pairs) for a branch.
#pragma GCC unroll 4
  for (std::size_t n = 0; n < 4; ++n) put(n);
  if (left != 0) {
#pragma GCC unroll 4
    for (std::size_t n = 4; n < 8; ++n) put(n);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#endif
