#include "engine/dynamics/contacts/collide_boxes_simd.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/collision/feature.h"
#include "engine/collision/rounding.h"

#define HWY_TARGET_INCLUDE "engine/dynamics/contacts/collide_boxes_simd.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/collision/many_pairs_axis.h"
#include "engine/dynamics/contacts/clip_faces_simd.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

static_assert(kNeighbours == kMostPairs);

/** Cosine of the angle between the normal of two edges and that of a face up to which
 the faces are taken to meet. Nearly parallel faces meet in a patch whose corners have
 depths of their own; the one contact of two edges would let the boxes rock on it. */
constexpr double kNearlyFace = 0.98;

/** What is known of each pair beforehand, a row for each number. */
struct alignas(64) PairRows {
  using Row = double[kMostPairs];

  // Of A and of B: axes, one after the other, place and half extents.
  Row R[2][9];
  Row p_W[2][3];
  Row h[2][3];
  Row margin;
  Row n_guess_W[3];
};

/** What is found of each pair. */
struct alignas(64) PairResults {
  using Row = double[kMostPairs];

  Row axis_separation;  ///< Along the axis of least overlap. [m]
  Row edges_meet;       ///< 1 where they do, else 0.
  Row separation;       ///< [m]
  Row n_W[3];
  PatchCorners corners;
};

void Put(const Neighbours& pair, std::size_t lane, PairRows& rows) {
  const std::array<const RigidBody*, 2> bodies = {pair.A, pair.B};
  for (std::size_t k = 0; k < 2; ++k) {
    const RigidBody& body = *bodies[k];
    const Eigen::Vector3d& h = std::get_if<Box>(&body.shape)->half_extents;
    for (std::size_t i = 0; i < 9; ++i) rows.R[k][i][lane] = body.R_WB.data()[i];
    for (std::size_t i = 0; i < 3; ++i) {
      rows.p_W[k][i][lane] = body.state.p_WB.data()[i];
      rows.h[k][i][lane] = h.data()[i];
    }
  }
  rows.margin[lane] = pair.margin;
  for (std::size_t i = 0; i < 3; ++i) {
    rows.n_guess_W[i][lane] = pair.n_guess_W.data()[i];
  }
}

/** Writes the axis of each pair, turned from A to B, along the axes of A and of B. */
HWY_INLINE void NormalsOf(const AxesOfPairs& found, const SeenPairs& seen,
                          PairVector n_A[3], PairVector n_B[3]) {
  const PairVector zero = All(0);
  const PairVector three = All(3);
  const PairMask is_edges = hn::Gt(found.axis, All(5.5));
  const PairMask is_A = hn::Lt(found.axis, All(2.5));
  // Of edges a_i × b_j with components −r2 and r1 along the axes of A after i, see
  // FacingOf().
  const PairVector edges = found.axis - All(6);
  const AxisMask i{hn::And(hn::Gt(edges, All(2.5)), hn::Lt(edges, All(5.5))),
                   hn::Gt(edges, All(5.5))};
  const PairVector column = edges - three * NumberOf(i);
  const AxisMask j{hn::Eq(column, All(1)), hn::Eq(column, All(2))};
  const PairVector sign = hn::IfThenElse(hn::Lt(found.offset, zero), All(-1), All(1));
  const PairVector scale = sign * (All(1) / found.sine);
  const PairVector R_j[3] = {Pick(j, seen.R[0]), Pick(j, seen.R[1]), Pick(j, seen.R[2])};
  PairVector R_ij[3];
  PickFrom(i, R_j, R_ij);
  const PairVector along_1 = (zero - R_ij[2]) * scale;
  const PairVector along_2 = R_ij[1] * scale;
  const PairVector of_edges[3] = {Pick(i, zero, along_2, along_1),
                                  Pick(i, along_1, zero, along_2),
                                  Pick(i, along_2, along_1, zero)};
  PairVector given_A[3];
  PairVector given_B[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto face = static_cast<double>(k);
    given_A[k] = hn::IfThenElse(
        is_edges, of_edges[k], hn::IfThenElse(hn::Eq(found.axis, All(face)), sign, zero));
    given_B[k] = hn::IfThenElse(hn::Eq(found.axis, All(3 + face)), sign, zero);
  }
  const PairMask in_A = hn::Or(is_edges, is_A);
  for (std::size_t k = 0; k < 3; ++k) {
    const PairVector R_k[3] = {seen.R[0][k], seen.R[1][k], seen.R[2][k]};
    n_A[k] = hn::IfThenElse(in_A, given_A[k], Dot(given_B, seen.R[k]));
    n_B[k] = hn::IfThenElse(in_A, Dot(given_A, R_k), given_B[k]);
  }
}

/** The face of each box that is most across the normal, and how it is turned. */
struct NearFaces {
  // By hand, see SeenPairs.
  HWY_INLINE NearFaces() {}

  AxisMask axis;
  PairVector cosine;  ///< Of the axis with the normal.
  PairVector side;    ///< +1 or −1, its sign.
  PairVector gap;     ///< Along the axis, on the side of the normal. [m]
  PairVector n_W[3];
};

/** `p_AB` is the centre of B from that of A and `n` the normal along the axes of the box,
 `axes` are those in the world. */
HWY_INLINE NearFaces FindNearFaces(const PairVector n[3], const PairVector p_AB[3],
                                   const PairVector reach[3],
                                   const PairVector axes[3][3]) {
  NearFaces face;
  face.axis = Steepest(n);
  face.cosine = Pick(face.axis, n);
  face.side = hn::IfThenElse(hn::Lt(face.cosine, All(0)), All(-1), All(1));
  face.gap = face.side * Pick(face.axis, p_AB) - Pick(face.axis, reach);
  for (std::size_t k = 0; k < 3; ++k) {
    face.n_W[k] = face.side * Pick(face.axis, axes[0][k], axes[1][k], axes[2][k]);
  }
  return face;
}

HWY_INLINE AxisMask Either(PairMask which, const AxisMask& yes, const AxisMask& no) {
  const auto either = [&](PairMask a, PairMask b) HWY_ATTR {
    return hn::Or(hn::And(which, a), hn::AndNot(which, b));
  };
  return {either(yes.is1, no.is1), either(yes.is2, no.is2)};
}

void CollideLanes(const PairRows& rows, std::size_t lane, PairResults& results) {
  const PairTag tag;
  const auto at = [&](const PairRows::Row& row)
                      HWY_ATTR { return hn::Load(tag, row + lane); };
  PairVector axes_A[3][3];
  PairVector axes_B[3][3];
  PairVector p_WA[3];
  PairVector p_WB[3];
  PairVector p_AB_W[3];
  PairVector h_A[3];
  PairVector h_B[3];
  PairVector n_guess_W[3];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      axes_A[k][c] = at(rows.R[0][3 * k + c]);
      axes_B[k][c] = at(rows.R[1][3 * k + c]);
    }
    p_WA[k] = at(rows.p_W[0][k]);
    p_WB[k] = at(rows.p_W[1][k]);
    p_AB_W[k] = p_WB[k] - p_WA[k];
    h_A[k] = at(rows.h[0][k]);
    h_B[k] = at(rows.h[1][k]);
    n_guess_W[k] = at(rows.n_guess_W[k]);
  }
  const PairVector margin = at(rows.margin);
  const SeenPairs seen = See(axes_A, axes_B, p_AB_W, h_A, h_B);
  const AxesOfPairs found = FindLeastOverlaps(seen);
  PairVector n_A[3];
  PairVector n_B[3];
  NormalsOf(found, seen, n_A, n_B);
  const NearFaces face_A = FindNearFaces(n_A, seen.p_AB_A, seen.reach_A, axes_A);
  const NearFaces face_B = FindNearFaces(n_B, seen.p_AB_B, seen.reach_B, axes_B);

  const PairMask is_steep =
      hn::Lt(hn::Max(hn::Abs(face_A.cosine), hn::Abs(face_B.cosine)), All(kNearlyFace));
  const PairMask edges_meet = hn::And(
      is_steep, hn::Gt(found.separation, hn::Max(face_A.gap, face_B.gap) + margin));
  // The face with the greater gap is the reference, but not by rounding: the one that was
  // it in the last step stays it within the margin, and A's where there is none.
  const PairMask was_B = hn::Gt(Dot(n_guess_W, face_B.n_W), Dot(n_guess_W, face_A.n_W));
  const PairVector half = All(0.5) * margin;
  const PairMask is_B = hn::Or(hn::And(was_B, hn::Gt(face_B.gap + half, face_A.gap)),
                               hn::AndNot(was_B, hn::Gt(face_B.gap, face_A.gap + half)));
  const PairVector gap = hn::IfThenElse(is_B, face_B.gap, face_A.gap);

  ReferenceFaces reference;
  reference.is_B = is_B;
  reference.axis = Either(is_B, face_B.axis, face_A.axis);
  reference.outward = hn::IfThenElse(is_B, All(0) - face_B.side, face_A.side);
  const PairMask has_patch =
      hn::Not(hn::Or(edges_meet, hn::Gt(found.separation, margin)));
  const PairMask of_B = hn::Gt(found.axis, All(2.5));
  const PairMask given_in_B = hn::And(of_B, hn::Lt(found.axis, All(5.5)));
  for (std::size_t k = 0; k < 3; ++k) {
    reference.n_W[k] = hn::IfThenElse(is_B, face_B.n_W[k], face_A.n_W[k]);
    reference.p_W[k] = hn::IfThenElse(is_B, p_WB[k], p_WA[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      reference.axes[i][k] = hn::IfThenElse(is_B, axes_B[i][k], axes_A[i][k]);
    }
    const PairVector A_k[3] = {axes_A[0][k], axes_A[1][k], axes_A[2][k]};
    const PairVector B_k[3] = {axes_B[0][k], axes_B[1][k], axes_B[2][k]};
    const PairVector of_axis = hn::IfThenElse(given_in_B, Dot(n_B, B_k), Dot(n_A, A_k));
    hn::Store(hn::IfThenElse(has_patch, reference.n_W[k], of_axis), tag,
              results.n_W[k] + lane);
  }
  hn::Store(found.separation, tag, results.axis_separation + lane);
  hn::Store(hn::IfThenElse(has_patch, gap, found.separation), tag,
            results.separation + lane);
  hn::Store(hn::IfThenElse(edges_meet, All(1), All(0)), tag, results.edges_meet + lane);
  FindPatches(seen, reference, gap, margin, lane, results.corners);
}

/** Which corners are contacts, each by where it is. */
struct Distinct {
  int count = 0;
  std::array<std::size_t, PatchCorners::kCount> corner;  ///< What it is called by.
  std::array<std::size_t, PatchCorners::kCount> place;   ///< Where it is.
};

/** Returns the corners that differ in x or y by more than kSameCorner slacks. One that
 stands for several is the first, but where the deepest is, if that is deeper by more than
 the slop: along a steep edge, what is no distance is many roundings of depth. */
Distinct WithoutRepeats(const PatchCorners& corners, unsigned kept, std::size_t lane) {
  const double slop = corners.slop[lane];
  const double distance = kSameCorner * slop;
  Distinct distinct;
  for (; kept != 0; kept &= kept - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(kept));
    bool repeats = false;
    for (std::size_t n = 0; n < static_cast<std::size_t>(distinct.count) && !repeats;
         ++n) {
      std::size_t& place = distinct.place[n];
      repeats = std::abs(corners.x[k][lane] - corners.x[place][lane]) <= distance &&
                std::abs(corners.y[k][lane] - corners.y[place][lane]) <= distance;
      if (repeats &&
          corners.separation[k][lane] < corners.separation[place][lane] - slop) {
        place = k;
      }
    }
    if (repeats) continue;
    const auto next = static_cast<std::size_t>(distinct.count++);
    distinct.corner[next] = distinct.place[next] = k;
  }
  return distinct;
}

/** Writes a contact, called by one corner and at the place of another. */
HWY_INLINE void PutContact(const PatchCorners& corners, std::size_t corner,
                           std::size_t place, std::size_t lane, ContactPoint& contact) {
  contact.p_WC = {corners.p_W[place][0][lane], corners.p_W[place][1][lane],
                  corners.p_W[place][2][lane]};
  // What only rounding lifts is not apart: corners of one face that lie on another would
  // be told to arrive there one after the other, which no rigid body can.
  const double z = corners.separation[place][lane];
  contact.separation = std::abs(z) <= corners.rounded[lane] ? 0 : z;
  contact.feature =
      static_cast<FeatureId>(static_cast<std::int32_t>(corners.feature[corner][lane]));
}

/** Returns whether two edges meet. */
bool Read(const PairResults& results, double margin, std::size_t lane,
          Manifold& manifold) {
  manifold.touching = results.axis_separation[lane] <= 0;
  manifold.separation = results.separation[lane];
  manifold.n_AB_W = {results.n_W[0][lane], results.n_W[1][lane], results.n_W[2][lane]};
  manifold.count = 0;
  if (results.axis_separation[lane] > margin) return false;
  if (results.edges_meet[lane] != 0) return true;

  constexpr int kMost = 8;
  const PatchCorners& corners = results.corners;
  auto kept = static_cast<unsigned>(static_cast<std::int32_t>(corners.kept[lane]));
  if (corners.may_repeat[lane] != 0) {
    const Distinct distinct = WithoutRepeats(corners, kept, lane);
    manifold.count = std::min(distinct.count, kMost);
    for (std::size_t n = 0; n < static_cast<std::size_t>(manifold.count); ++n) {
      PutContact(corners, distinct.corner[n], distinct.place[n], lane,
                 manifold.contacts[n]);
    }
    return false;
  }
  manifold.count = std::min(std::popcount(kept), kMost);
  for (std::size_t n = 0; n < static_cast<std::size_t>(manifold.count); ++n) {
    const auto k = static_cast<std::size_t>(std::countr_zero(kept));
    PutContact(corners, k, k, lane, manifold.contacts[n]);
    kept &= kept - 1;
  }
  return false;
}

unsigned CollideAll(std::span<const Neighbours> boxes) {
  PairRows rows;
  for (std::size_t k = 0; k < kMostPairs; ++k) {
    // Lanes without a pair repeat the last: what is found of them is not read.
    Put(boxes[std::min(k, boxes.size() - 1)], k, rows);
  }
  PairResults results;
  for (std::size_t lane = 0; lane < boxes.size(); lane += hn::Lanes(PairTag())) {
    CollideLanes(rows, lane, results);
  }
  unsigned edges_meet = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (Read(results, boxes[k].margin, k, *boxes[k].manifold)) edges_meet |= 1u << k;
  }
  return edges_meet;
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
unsigned CollideBoxesSimd(std::span<const Neighbours> boxes) {
  return COOKBOOK_DISPATCH(CollideAll)(boxes);
}
}  // namespace cookbook
#endif
