// Face clipping, edge by edge (Liang-Barsky), for a vector of pairs of boxes. Include it
// after engine/simd/foreach_target.h, in a file that foreach_target.h includes
// repeatedly; hence the include guard that toggles.
//
// The method is that of engine/collision/one_pair_contacts.h for one pair: the incident
// face, a parallelogram, is clipped to the reference face, a rectangle. Here the
// projection is always along the normal of the reference face, and speculative corners
// are kept.

#if defined(COOKBOOK_ENGINE_CLIP_FACES_SIMD_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_CLIP_FACES_SIMD_H_
#undef COOKBOOK_ENGINE_CLIP_FACES_SIMD_H_
#else
#define COOKBOOK_ENGINE_CLIP_FACES_SIMD_H_
#endif

#include <cstddef>

#include <hwy/highway.h>

#include "engine/collision/feature.h"
#include "engine/collision/many_pairs_axis.h"
#include "engine/collision/rounding.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {

/** An axis index 0, 1 or 2 per pair, as masks: 0 if neither is set. */
struct AxisMask {
  // Written out for the reason given at SeenPairs.
  HWY_INLINE AxisMask() {}
  HWY_INLINE AxisMask(PairMask one, PairMask two) : is1(one), is2(two) {}

  PairMask is1;
  PairMask is2;
};

/** Returns x0, x1 or x2, as `axis` selects. */
HWY_INLINE PairVector Pick(const AxisMask& axis, PairVector x0, PairVector x1,
                           PairVector x2) {
  namespace hn = hwy::HWY_NAMESPACE;
  return hn::IfThenElse(axis.is2, x2, hn::IfThenElse(axis.is1, x1, x0));
}
HWY_INLINE PairVector Pick(const AxisMask& axis, const PairVector x[3]) {
  return Pick(axis, x[0], x[1], x[2]);
}

/** Cyclically permutes x: writes the values of `axis` and of the two axes after it. */
HWY_INLINE void PickCyclic(const AxisMask& axis, const PairVector x[3],
                           PairVector out[3]) {
  out[0] = Pick(axis, x[0], x[1], x[2]);
  out[1] = Pick(axis, x[1], x[2], x[0]);
  out[2] = Pick(axis, x[2], x[0], x[1]);
}

/** Returns the first axis along which |x| is greatest. */
HWY_INLINE AxisMask LargestComponent(const PairVector x[3]) {
  namespace hn = hwy::HWY_NAMESPACE;
  const PairVector x0 = hn::Abs(x[0]);
  const PairVector x1 = hn::Abs(x[1]);
  const PairVector x2 = hn::Abs(x[2]);
  const PairMask is2 = hn::Gt(x2, hn::Max(x0, x1));
  return {hn::AndNot(is2, hn::Gt(x1, x0)), is2};
}

/** Returns the index of an axis as a number. */
HWY_INLINE PairVector IndexOf(const AxisMask& axis) {
  return Pick(axis, All(0), All(1), All(2));
}

/** The reference face of each pair. */
struct ReferenceFaces {
  // Written out for the reason given at SeenPairs.
  HWY_INLINE ReferenceFaces() {}

  PairMask is_B;          ///< Whether it is a face of B.
  AxisMask axis;          ///< Axis of its box perpendicular to it.
  PairVector outward;     ///< +1 or −1: side of its box along the axis.
  PairVector n_W[3];      ///< Normal from A to B.
  PairVector axes[3][3];  ///< Axes of its box in the world frame.
  PairVector p_W[3];      ///< Centre of its box. [m]
};

/** The candidates for contact points of each pair. 0…3: points where an edge of the
 incident face enters the reference face, or its first corner if that is inside. 4…7:
 points where it leaves. 8…11: corners of the reference face. */
struct alignas(64) CandidateCorners {
  static constexpr std::size_t kCount = 12;
  using Row = double[kMostPairs];

  Row kept;        ///< Mask of the candidates that are contact points.
  Row may_repeat;  ///< 1 if two of them may be equal to rounding, else 0.
  Row tolerance;   ///< Distance by which flush corners may be outside. [m]
  Row rounded;     ///< Separations within ± this are zero. [m]
  // Per candidate:
  Row p_W[kCount][3];
  Row separation[kCount];
  Row feature[kCount];  ///< See FaceContactId().
  Row x[kCount];        ///< Coordinate on the reference face. [m]
  Row y[kCount];        ///< Coordinate on the reference face. [m]
};

/** Tolerance for flush corners, as a fraction of the margin. Boxes that are stacked flush
 drift by more than rounding but far less than the margin. Without a tolerance that drift
 alone would decide where their nearly parallel edges cross, and hence the number of
 contact points. */
constexpr double kFlushTolerance = 1e-3;

/** The incident face in the frame of the reference face: x and y along the edges of that
 face from its centre, z the separation. Its corners are centre ± side1 ± side2. [m] */
struct IncidentFaces {
  // Written out for the reason given at SeenPairs.
  HWY_INLINE IncidentFaces() {}

  PairVector centre[3];
  PairVector side1[3];
  PairVector side2[3];
  PairVector h[3];   ///< Half extents of the reference box: along the normal, x and y.
  PairVector faces;  ///< FaceContactId() without the edges.
};

HWY_INLINE IncidentFaces FindIncidentFaces(const SeenPairs& pairs,
                                           const ReferenceFaces& reference) {
  namespace hn = hwy::HWY_NAMESPACE;
  const PairMask is_B = reference.is_B;
  // The axes of the incident box in the frame of the reference box, column by column.
  PairVector R[3][3];
  PairVector p_AB[3];
  PairVector h_R[3];
  PairVector h_I[3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      R[j][i] = hn::IfThenElse(is_B, pairs.R[j][i], pairs.R[i][j]);
    }
    p_AB[i] = hn::IfThenElse(is_B, pairs.p_AB_B[i], pairs.p_AB_A[i]);
    h_R[i] = hn::IfThenElse(is_B, pairs.h_B[i], pairs.h_A[i]);
    h_I[i] = hn::IfThenElse(is_B, pairs.h_A[i], pairs.h_B[i]);
  }
  // The same with the components along the normal, x and y of the reference face.
  PairVector axes[3][3];
  for (std::size_t j = 0; j < 3; ++j) PickCyclic(reference.axis, R[j], axes[j]);
  PairVector t[3];
  PickCyclic(reference.axis, p_AB, t);

  IncidentFaces incident;
  PickCyclic(reference.axis, h_R, incident.h);
  const PairVector towards = hn::IfThenElse(is_B, All(-1), All(1));
  const PairVector n_I[3] = {reference.outward * axes[0][0],
                             reference.outward * axes[1][0],
                             reference.outward * axes[2][0]};
  const AxisMask k = LargestComponent(n_I);
  PairVector h[3];
  PickCyclic(k, h_I, h);
  const PairVector reach = hn::CopySign(h[0], All(0) - Pick(k, n_I));
  const PairVector incident_up = hn::IfThenElse(hn::Gt(reach, All(0)), All(1), All(0));
  const PairVector reference_up =
      hn::IfThenElse(hn::Gt(reference.outward, All(0)), All(1), All(0));
  const PairVector eight = All(8);
  incident.faces = eight * eight *
                   (eight * (eight * hn::IfThenElse(is_B, All(3), All(2)) +
                             (All(2) * IndexOf(reference.axis) + reference_up)) +
                    (All(2) * IndexOf(k) + incident_up));
  for (std::size_t c = 0; c < 3; ++c) {
    const PairVector components[3] = {axes[0][c], axes[1][c], axes[2][c]};
    PairVector along[3];
    PickCyclic(k, components, along);
    const PairVector centre = towards * t[c] + reach * along[0];
    const PairVector side1 = h[1] * along[1];
    const PairVector side2 = h[2] * along[2];
    if (c == 0) {
      incident.centre[2] = reference.outward * centre - incident.h[0];
      incident.side1[2] = reference.outward * side1;
      incident.side2[2] = reference.outward * side2;
    } else {
      incident.centre[c - 1] = centre;
      incident.side1[c - 1] = side1;
      incident.side2[c - 1] = side2;
    }
  }
  return incident;
}

/** Returns 1 / x, or the huge number 1e300 if x is nearly zero. That number is finite, so
 that no 0 · ∞ arises for a corner on the line. */
HWY_INLINE PairVector SafeInverse(PairVector x) {
  namespace hn = hwy::HWY_NAMESPACE;
  const PairVector least = All(1e-300);
  return All(1) / hn::IfThenElse(hn::Lt(hn::Abs(x), least), least, x);
}

/** Clips the incident face to the reference face. Fills the lanes of `corners` from
 `lane` on. `separation`: least separation of each pair. [m] `margin`: its speculative
 margin. [m]
 */
HWY_INLINE void ClipFaces(const SeenPairs& pairs, const ReferenceFaces& reference,
                          PairVector separation, PairVector margin, std::size_t lane,
                          CandidateCorners& corners) {
  namespace hn = hwy::HWY_NAMESPACE;
  const PairTag tag;
  const IncidentFaces face = FindIncidentFaces(pairs, reference);
  const PairVector* c = face.centre;
  const PairVector* u = face.side1;
  const PairVector* v = face.side2;
  const PairVector zero = All(0);
  const PairVector one = All(1);
  const PairVector size = SizeOf(pairs);
  const PairVector tolerance = hn::Max(All(kFlush) * size, All(kFlushTolerance) * margin);
  const PairVector rounded = All(kOverlapRounding) * size;
  const PairVector h_x = face.h[1];
  const PairVector h_y = face.h[2];

  // The transformation from the reference face to the world.
  PairVector axes_W[3][3];
  PairVector p_W[3];
  PairVector half_n_W[3];
  const PairVector half = hn::IfThenElse(reference.is_B, All(-0.5), All(0.5));
  for (std::size_t k = 0; k < 3; ++k) {
    const PairVector components[3] = {reference.axes[0][k], reference.axes[1][k],
                                      reference.axes[2][k]};
    PickCyclic(reference.axis, components, axes_W[k]);
    p_W[k] = reference.p_W[k] + (reference.outward * face.h[0]) * axes_W[k][0];
    half_n_W[k] = half * reference.n_W[k];
  }
  PairVector kept = zero;
  const auto add = [&](std::size_t n, PairMask is_corner, PairVector x, PairVector y,
                       PairVector gap, PairVector feature) HWY_ATTR {
    kept = kept + hn::IfThenElse(hn::And(is_corner, hn::Le(gap, margin)),
                                 All(static_cast<double>(1u << n)), zero);
    const PairVector deepest = hn::Max(gap, separation);
    const PairVector z = hn::IfThenElse(hn::Le(hn::Abs(deepest), rounded), zero, deepest);
    for (std::size_t k = 0; k < 3; ++k) {
      hn::Store(p_W[k] + (x * axes_W[k][1] + y * axes_W[k][2] + z * half_n_W[k]), tag,
                corners.p_W[n][k] + lane);
    }
    hn::Store(deepest, tag, corners.separation[n] + lane);
    hn::Store(feature, tag, corners.feature[n] + lane);
    hn::Store(x, tag, corners.x[n] + lane);
    hn::Store(y, tag, corners.y[n] + lane);
  };

  // Flush faces share corners, which rounding must not cut off. So the clip lines are
  // moved outwards by the tolerance, and the clipped points are moved back to the face.
  const PairVector bound_x = h_x + tolerance;
  const PairVector bound_y = h_y + tolerance;
  // Corner k, from which an edge goes to the next corner: along −side1, −side2, side1 and
  // side2.
  const PairVector x[4] = {c[0] + u[0] + v[0], c[0] - u[0] + v[0], c[0] - u[0] - v[0],
                           c[0] + u[0] - v[0]};
  const PairVector y[4] = {c[1] + u[1] + v[1], c[1] - u[1] + v[1], c[1] - u[1] - v[1],
                           c[1] + u[1] - v[1]};
  const PairVector z[4] = {c[2] + u[2] + v[2], c[2] - u[2] + v[2], c[2] - u[2] - v[2],
                           c[2] + u[2] - v[2]};
  const PairVector two = All(2);
  PairMask inside[4];
  // Two candidates can be equal only if a corner of one face is near a line of the other.
  // They are within √2 kSameCorner times the tolerance of each other. The incident face
  // is tilted by at most 55°, so the angle between its adjacent edges is never so flat
  // that their corner is more than three times as far from the line.
  const PairVector near = All(4 * kSameCorner) * tolerance;
  PairMask may_repeat = hn::Lt(near, zero);
  for (std::size_t k = 0; k < 4; ++k) {
    const PairVector abs_x = hn::Abs(x[k]);
    const PairVector abs_y = hn::Abs(y[k]);
    inside[k] = hn::And(hn::Le(abs_x, bound_x), hn::Le(abs_y, bound_y));
    may_repeat = hn::Or(may_repeat, hn::Or(hn::Le(hn::Abs(abs_x - bound_x), near),
                                           hn::Le(hn::Abs(abs_y - bound_y), near)));
  }
  // The edges of the incident face that start and that end at its corners.
  constexpr FaceEdge kEdge[4] = {3, 0, 2, 1};
  constexpr double kCorner[4] = {EdgesId(1, 3), EdgesId(3, 0), EdgesId(0, 2),
                                 EdgesId(2, 1)};
  for (std::size_t k = 0; k < 4; ++k) {
    const PairVector* side = k % 2 == 0 ? u : v;
    const PairVector length = k < 2 ? zero - two : two;
    const PairVector dx = side[0] * length;
    const PairVector dy = side[1] * length;
    const PairVector dz = side[2] * length;
    const PairMask next_inside = inside[(k + 1) % 4];
    // The edge parameters, in [0, 1], at which it crosses the clip lines.
    const PairVector per_x = SafeInverse(dx);
    const PairVector per_y = SafeInverse(dy);
    const PairVector x1 = (zero - bound_x - x[k]) * per_x;
    const PairVector x2 = (bound_x - x[k]) * per_x;
    const PairVector y1 = (zero - bound_y - y[k]) * per_y;
    const PairVector y2 = (bound_y - y[k]) * per_y;
    const PairVector enter_x = hn::Min(x1, x2);
    const PairVector enter_y = hn::Min(y1, y2);
    const PairVector leave_x = hn::Max(x1, x2);
    const PairVector leave_y = hn::Max(y1, y2);
    // If the first corner is inside, both are at most 0, and `enter` is 0: the corner.
    const PairVector enter = hn::Min(hn::Max(hn::Max(enter_x, enter_y), zero), one);
    const PairVector leave = hn::Max(hn::Min(hn::Min(leave_x, leave_y), one), zero);
    // If an end of the edge is inside, that alone decides, and the adjacent edge agrees.
    const PairMask inside_or_crosses = hn::Or(inside[k], hn::Lt(enter, leave));
    const PairMask enters = hn::Or(inside_or_crosses, next_inside);
    const PairMask leaves = hn::AndNot(next_inside, inside_or_crosses);
    const PairMask up_x = hn::Gt(per_x, zero);
    const PairMask up_y = hn::Gt(per_y, zero);
    const PairVector edge = All(static_cast<double>(kEdge[k] << 3)) + face.faces;
    const PairVector enter_line =
        hn::IfThenElse(hn::Gt(enter_x, enter_y), hn::IfThenElse(up_x, All(4), All(5)),
                       hn::IfThenElse(up_y, All(6), All(7)));
    const PairVector leave_line =
        hn::IfThenElse(hn::Lt(leave_x, leave_y), hn::IfThenElse(up_x, All(5), All(4)),
                       hn::IfThenElse(up_y, All(7), All(6)));
    const auto clamp = [](PairVector at, PairVector bound) HWY_ATTR {
      return hn::Min(hn::Max(at, All(0) - bound), bound);
    };
    add(k, enters, clamp(x[k] + enter * dx, h_x), clamp(y[k] + enter * dy, h_y),
        z[k] + enter * dz,
        hn::IfThenElse(inside[k], All(kCorner[k]) + face.faces, edge + enter_line));
    add(k + 4, leaves, clamp(x[k] + leave * dx, h_x), clamp(y[k] + leave * dy, h_y),
        z[k] + leave * dz, edge + leave_line);
  }

  // The corners of the rectangle inside the parallelogram, with the same tolerance.
  const PairVector area = u[0] * v[1] - u[1] * v[0];
  const PairVector abs_area = hn::Abs(area);
  const PairVector tolerance_u = tolerance * (hn::Abs(v[0]) + hn::Abs(v[1]));
  const PairVector tolerance_v = tolerance * (hn::Abs(u[0]) + hn::Abs(u[1]));
  const PairVector near_u = All(4 * kSameCorner) * tolerance_u;
  const PairVector near_v = All(4 * kSameCorner) * tolerance_v;
  constexpr double kCornerOfReference[4] = {EdgesId(5, 7), EdgesId(4, 7), EdgesId(4, 6),
                                            EdgesId(5, 6)};
  for (std::size_t k = 0; k < 4; ++k) {
    const PairVector corner_x = k == 0 || k == 3 ? h_x : zero - h_x;
    const PairVector corner_y = k < 2 ? h_y : zero - h_y;
    const PairVector from_x = corner_x - c[0];
    const PairVector from_y = corner_y - c[1];
    const PairVector along_u = from_x * v[1] - from_y * v[0];
    const PairVector along_v = from_y * u[0] - from_x * u[1];
    const PairVector beyond_u = hn::Abs(along_u) - abs_area;
    const PairVector beyond_v = hn::Abs(along_v) - abs_area;
    may_repeat = hn::Or(may_repeat, hn::Or(hn::Le(hn::Abs(beyond_u), near_u),
                                           hn::Le(hn::Abs(beyond_v), near_v)));
    add(k + 8, hn::And(hn::Le(beyond_u, tolerance_u), hn::Le(beyond_v, tolerance_v)),
        corner_x, corner_y, c[2] + (along_u * u[2] + along_v * v[2]) / area,
        All(kCornerOfReference[k]) + face.faces);
  }
  hn::Store(kept, tag, corners.kept + lane);
  hn::Store(hn::IfThenElse(may_repeat, one, zero), tag, corners.may_repeat + lane);
  hn::Store(tolerance, tag, corners.tolerance + lane);
  hn::Store(rounded, tag, corners.rounded + lane);
}

}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
