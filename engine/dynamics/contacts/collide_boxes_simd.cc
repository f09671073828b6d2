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

static_assert(kPairsPerBatch == kMostPairs);

/** Cosine of the angle between the normal of two edges and that of a face. For smaller
 angles the contact is on the face, unless the boxes are much deeper in each other along
 it. The corners of the patch of two nearly parallel faces have their own depths; on the
 one contact of two edges the boxes would rock. */
constexpr double kMinFaceCosine = 0.98;

/** How much deeper the boxes may be along such a face than along the normal of the edges,
 as a fraction of the least half extent. The end of a long bar that leans on an edge is
 far below the face that the bar crosses at a small angle. */
constexpr double kFaceDepth = 0.05;

/** The input of a batch as a structure of arrays, indexed by pair. */
struct alignas(64) BatchInput {
  using Row = double[kMostPairs];

  // First index: body A or B.
  Row R[2][9];    ///< Axes of the body, one after the other.
  Row p_W[2][3];  ///< Position. [m]
  Row h[2][3];    ///< Half extents. [m]
  Row margin;
  Row n_guess_W[3];
};

/** The output of a batch as a structure of arrays, indexed by pair. */
struct alignas(64) BatchResults {
  using Row = double[kMostPairs];

  Row axis_separation;  ///< Separation along the axis of least overlap. [m]
  Row edge_contacts;    ///< 1 if the contact is between two edges, else 0.
  Row separation;       ///< [m]
  Row n_W[3];
  CandidateCorners corners;
};

void LoadPair(const CollisionPair& pair, std::size_t lane, BatchInput& input) {
  const std::array<const RigidBody*, 2> bodies = {pair.A, pair.B};
  for (std::size_t k = 0; k < 2; ++k) {
    const RigidBody& body = *bodies[k];
    const Eigen::Vector3d& h = std::get_if<Box>(&body.shape)->half_extents;
    for (std::size_t i = 0; i < 9; ++i) input.R[k][i][lane] = body.R_WB.data()[i];
    for (std::size_t i = 0; i < 3; ++i) {
      input.p_W[k][i][lane] = body.state.p_WB.data()[i];
      input.h[k][i][lane] = h.data()[i];
    }
  }
  input.margin[lane] = pair.margin;
  for (std::size_t i = 0; i < 3; ++i) {
    input.n_guess_W[i][lane] = pair.n_guess_W.data()[i];
  }
}

/** Returns the normal of each pair, from A to B, in the frames of A and of B. */
HWY_INLINE void FindNormals(const AxesOfPairs& found, const SeenPairs& seen,
                            PairVector n_A[3], PairVector n_B[3]) {
  const PairVector zero = All(0);
  const PairVector three = All(3);
  const PairMask is_edges = hn::Gt(found.axis, All(5.5));
  const PairMask is_A = hn::Lt(found.axis, All(2.5));
  // For edges the normal is a_i × b_j, which has the components −r2 and r1 along the axes
  // of A after i, see FacingOf().
  const PairVector edges = found.axis - All(6);
  const AxisMask i{hn::And(hn::Gt(edges, All(2.5)), hn::Lt(edges, All(5.5))),
                   hn::Gt(edges, All(5.5))};
  const PairVector column = edges - three * IndexOf(i);
  const AxisMask j{hn::Eq(column, All(1)), hn::Eq(column, All(2))};
  const PairVector sign = hn::IfThenElse(hn::Lt(found.offset, zero), All(-1), All(1));
  const PairVector scale = sign * (All(1) / found.sine);
  const PairVector R_j[3] = {Pick(j, seen.R[0]), Pick(j, seen.R[1]), Pick(j, seen.R[2])};
  PairVector R_ij[3];
  PickCyclic(i, R_j, R_ij);
  const PairVector along_1 = (zero - R_ij[2]) * scale;
  const PairVector along_2 = R_ij[1] * scale;
  const PairVector edges_A[3] = {Pick(i, zero, along_2, along_1),
                                 Pick(i, along_1, zero, along_2),
                                 Pick(i, along_2, along_1, zero)};
  PairVector axis_A[3];
  PairVector axis_B[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto face = static_cast<double>(k);
    axis_A[k] = hn::IfThenElse(is_edges, edges_A[k],
                               hn::IfThenElse(hn::Eq(found.axis, All(face)), sign, zero));
    axis_B[k] = hn::IfThenElse(hn::Eq(found.axis, All(3 + face)), sign, zero);
  }
  const PairMask in_A = hn::Or(is_edges, is_A);
  for (std::size_t k = 0; k < 3; ++k) {
    const PairVector R_k[3] = {seen.R[0][k], seen.R[1][k], seen.R[2][k]};
    n_A[k] = hn::IfThenElse(in_A, axis_A[k], Dot(axis_B, seen.R[k]));
    n_B[k] = hn::IfThenElse(in_A, Dot(axis_A, R_k), axis_B[k]);
  }
}

/** The supporting face of one box of each pair: the face that is most perpendicular to
 the normal. */
struct SupportingFaces {
  // Written out for the reason given at SeenPairs.
  HWY_INLINE SupportingFaces() {}

  AxisMask axis;      ///< Axis of the box perpendicular to the face.
  PairVector cosine;  ///< Cosine of the angle between axis and normal.
  PairVector side;    ///< Sign of `cosine`, +1 or −1.
  PairVector gap;     ///< Separation of the boxes along the axis. [m]
  PairVector n_W[3];  ///< Normal of the face, from A to B.
};

/** Returns the supporting faces. `n` is the normal and `p_AB` the vector between the
 centres, both in the frame of the box; `axes` are the axes of the box in the world frame.
 */
HWY_INLINE SupportingFaces FindSupportingFaces(const PairVector n[3],
                                               const PairVector p_AB[3],
                                               const PairVector reach[3],
                                               const PairVector axes[3][3]) {
  SupportingFaces face;
  face.axis = LargestComponent(n);
  face.cosine = Pick(face.axis, n);
  face.side = hn::IfThenElse(hn::Lt(face.cosine, All(0)), All(-1), All(1));
  face.gap = face.side * Pick(face.axis, p_AB) - Pick(face.axis, reach);
  for (std::size_t k = 0; k < 3; ++k) {
    face.n_W[k] = face.side * Pick(face.axis, axes[0][k], axes[1][k], axes[2][k]);
  }
  return face;
}

HWY_INLINE AxisMask Select(PairMask which, const AxisMask& yes, const AxisMask& no) {
  const auto select = [&](PairMask a, PairMask b) HWY_ATTR {
    return hn::Or(hn::And(which, a), hn::AndNot(which, b));
  };
  return {select(yes.is1, no.is1), select(yes.is2, no.is2)};
}

void CollideLanes(const BatchInput& input, std::size_t lane, BatchResults& results) {
  const PairTag tag;
  const auto at = [&](const BatchInput::Row& row)
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
      axes_A[k][c] = at(input.R[0][3 * k + c]);
      axes_B[k][c] = at(input.R[1][3 * k + c]);
    }
    p_WA[k] = at(input.p_W[0][k]);
    p_WB[k] = at(input.p_W[1][k]);
    p_AB_W[k] = p_WB[k] - p_WA[k];
    h_A[k] = at(input.h[0][k]);
    h_B[k] = at(input.h[1][k]);
    n_guess_W[k] = at(input.n_guess_W[k]);
  }
  const PairVector margin = at(input.margin);
  const SeenPairs seen = See(axes_A, axes_B, p_AB_W, h_A, h_B);
  const AxesOfPairs found = FindLeastOverlaps(seen);
  PairVector n_A[3];
  PairVector n_B[3];
  FindNormals(found, seen, n_A, n_B);
  const SupportingFaces face_A =
      FindSupportingFaces(n_A, seen.p_AB_A, seen.reach_A, axes_A);
  const SupportingFaces face_B =
      FindSupportingFaces(n_B, seen.p_AB_B, seen.reach_B, axes_B);

  PairVector thinnest = hn::Min(h_A[0], h_B[0]);
  for (std::size_t k = 1; k < 3; ++k)
    thinnest = hn::Min(thinnest, hn::Min(h_A[k], h_B[k]));
  const PairVector least_gap =
      found.separation - hn::Max(margin, All(kFaceDepth) * thinnest);
  const auto is_near = [&](const SupportingFaces& face) HWY_ATTR {
    return hn::And(hn::Ge(hn::Abs(face.cosine), All(kMinFaceCosine)),
                   hn::Ge(face.gap, least_gap));
  };
  const PairMask edge_contacts =
      hn::AndNot(hn::Or(is_near(face_A), is_near(face_B)),
                 hn::Gt(found.separation, hn::Max(face_A.gap, face_B.gap) + margin));
  // The face with the greater gap is the reference face. Rounding must not decide it, so
  // the reference face of the last step stays within half the margin. Without a last step
  // it is that of A.
  const PairMask was_B = hn::Gt(Dot(n_guess_W, face_B.n_W), Dot(n_guess_W, face_A.n_W));
  const PairVector half = All(0.5) * margin;
  const PairMask is_B = hn::Or(hn::And(was_B, hn::Gt(face_B.gap + half, face_A.gap)),
                               hn::AndNot(was_B, hn::Gt(face_B.gap, face_A.gap + half)));
  const PairVector gap = hn::IfThenElse(is_B, face_B.gap, face_A.gap);

  ReferenceFaces reference;
  reference.is_B = is_B;
  reference.axis = Select(is_B, face_B.axis, face_A.axis);
  reference.outward = hn::IfThenElse(is_B, All(0) - face_B.side, face_A.side);
  const PairMask has_patch =
      hn::Not(hn::Or(edge_contacts, hn::Gt(found.separation, margin)));
  const PairMask is_B_or_edges = hn::Gt(found.axis, All(2.5));
  const PairMask is_face_of_B = hn::And(is_B_or_edges, hn::Lt(found.axis, All(5.5)));
  for (std::size_t k = 0; k < 3; ++k) {
    reference.n_W[k] = hn::IfThenElse(is_B, face_B.n_W[k], face_A.n_W[k]);
    reference.p_W[k] = hn::IfThenElse(is_B, p_WB[k], p_WA[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      reference.axes[i][k] = hn::IfThenElse(is_B, axes_B[i][k], axes_A[i][k]);
    }
    const PairVector A_k[3] = {axes_A[0][k], axes_A[1][k], axes_A[2][k]};
    const PairVector B_k[3] = {axes_B[0][k], axes_B[1][k], axes_B[2][k]};
    const PairVector of_axis = hn::IfThenElse(is_face_of_B, Dot(n_B, B_k), Dot(n_A, A_k));
    hn::Store(hn::IfThenElse(has_patch, reference.n_W[k], of_axis), tag,
              results.n_W[k] + lane);
  }
  hn::Store(found.separation, tag, results.axis_separation + lane);
  hn::Store(hn::IfThenElse(has_patch, gap, found.separation), tag,
            results.separation + lane);
  hn::Store(hn::IfThenElse(edge_contacts, All(1), All(0)), tag,
            results.edge_contacts + lane);
  ClipFaces(seen, reference, gap, margin, lane, results.corners);
}

/** The corners that become contact points. */
struct DistinctCorners {
  int count = 0;
  std::array<std::size_t, CandidateCorners::kCount>
      corner;  ///< Corner that has the feature.
  std::array<std::size_t, CandidateCorners::kCount>
      position;  ///< Corner that has the position.
};

/** Returns the corners that differ in x or y by more than kSameCorner times the
 tolerance. If corners are equal, the first has the feature. The deepest has the
 position if it is deeper by more than the tolerance: along a steep edge, a negligible
 distance is many times the rounding in depth. */
DistinctCorners MergeEqualCorners(const CandidateCorners& corners, unsigned kept,
                                  std::size_t lane) {
  const double tolerance = corners.tolerance[lane];
  const double distance = kSameCorner * tolerance;
  DistinctCorners distinct;
  for (; kept != 0; kept &= kept - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(kept));
    bool is_equal = false;
    for (std::size_t n = 0; n < static_cast<std::size_t>(distinct.count) && !is_equal;
         ++n) {
      std::size_t& position = distinct.position[n];
      is_equal = std::abs(corners.x[k][lane] - corners.x[position][lane]) <= distance &&
                 std::abs(corners.y[k][lane] - corners.y[position][lane]) <= distance;
      if (is_equal &&
          corners.separation[k][lane] < corners.separation[position][lane] - tolerance) {
        position = k;
      }
    }
    if (is_equal) continue;
    const auto next = static_cast<std::size_t>(distinct.count++);
    distinct.corner[next] = distinct.position[next] = k;
  }
  return distinct;
}

/** Writes a contact point with the feature of one corner and the position of another. */
HWY_INLINE void WriteContact(const CandidateCorners& corners, std::size_t corner,
                             std::size_t position, std::size_t lane,
                             ContactPoint& contact) {
  contact.p_WC = {corners.p_W[position][0][lane], corners.p_W[position][1][lane],
                  corners.p_W[position][2][lane]};
  // Rounding must not separate a contact point: the corners of a face that lies on
  // another would have to arrive there one after the other, which no rigid body can.
  const double z = corners.separation[position][lane];
  contact.separation = std::abs(z) <= corners.rounded[lane] ? 0 : z;
  contact.feature =
      static_cast<FeatureId>(static_cast<std::int32_t>(corners.feature[corner][lane]));
}

/** Writes the manifold of a pair. Returns whether the contact is between two edges. */
bool WriteManifold(const BatchResults& results, double margin, std::size_t lane,
                   Manifold& manifold) {
  manifold.touching = results.axis_separation[lane] <= 0;
  manifold.separation = results.separation[lane];
  manifold.n_AB_W = {results.n_W[0][lane], results.n_W[1][lane], results.n_W[2][lane]};
  manifold.count = 0;
  if (results.axis_separation[lane] > margin) return false;
  if (results.edge_contacts[lane] != 0) return true;

  constexpr int kMaxContacts = 8;
  const CandidateCorners& corners = results.corners;
  auto kept = static_cast<unsigned>(static_cast<std::int32_t>(corners.kept[lane]));
  if (corners.may_repeat[lane] != 0) {
    const DistinctCorners distinct = MergeEqualCorners(corners, kept, lane);
    manifold.count = std::min(distinct.count, kMaxContacts);
    for (std::size_t n = 0; n < static_cast<std::size_t>(manifold.count); ++n) {
      WriteContact(corners, distinct.corner[n], distinct.position[n], lane,
                   manifold.contacts[n]);
    }
    return false;
  }
  manifold.count = std::min(std::popcount(kept), kMaxContacts);
  for (std::size_t n = 0; n < static_cast<std::size_t>(manifold.count); ++n) {
    const auto k = static_cast<std::size_t>(std::countr_zero(kept));
    WriteContact(corners, k, k, lane, manifold.contacts[n]);
    kept &= kept - 1;
  }
  return false;
}

unsigned CollideAll(std::span<const CollisionPair> batch) {
  BatchInput input;
  for (std::size_t k = 0; k < kMostPairs; ++k) {
    // Lanes without a pair repeat the last pair. Their results are not read.
    LoadPair(batch[std::min(k, batch.size() - 1)], k, input);
  }
  BatchResults results;
  for (std::size_t lane = 0; lane < batch.size(); lane += hn::Lanes(PairTag())) {
    CollideLanes(input, lane, results);
  }
  unsigned edge_contacts = 0;
  for (std::size_t k = 0; k < batch.size(); ++k) {
    if (WriteManifold(results, batch[k].margin, k, *batch[k].manifold))
      edge_contacts |= 1u << k;
  }
  return edge_contacts;
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
unsigned CollideBoxesSimd(std::span<const CollisionPair> batch) {
  return COOKBOOK_DISPATCH(CollideAll)(batch);
}
}  // namespace cookbook
#endif
