#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/box_contacts.h"
#include "engine/feature.h"

namespace cookbook {
namespace {

/** A corner of the incident face as the reference face sees it: x and y along that face's
 edges from its centre, z outward from its plane. */
struct Corner {
  double x;          ///< [m]
  double y;          ///< [m]
  double z;          ///< Signed gap to the plane of the reference face. [m]
  FaceEdge leaving;  ///< The edge towards the next corner.
};

struct Polygon {
  /** Clipping a convex polygon by a line adds one corner at most, so that eight would do;
   where rounding makes it concave, corners may alternate about the line, and n become
   3n/2. */
  std::array<Corner, 19> corners;
  int count = 0;

  Corner& operator[](int k) { return corners[static_cast<std::size_t>(k)]; }
  const Corner& operator[](int k) const { return corners[static_cast<std::size_t>(k)]; }
};

/** Keeps the part of `in` where side · coordinate ≤ bound (Sutherland and Hodgman, CACM
 17(1), 1974). Returns `in` where nothing is cut off, else the result in `room`. */
template <double Corner::*coordinate, int side>
const Polygon& Clip(const Polygon& in, double bound, FaceEdge line, Polygon& room) {
  bool all_inside = true;
  for (int k = 0; k < in.count; ++k) {
    all_inside = all_inside && side * (in[k].*coordinate) <= bound;
  }
  if (all_inside) return in;

  int count = 0;
  const Corner* from = &in[in.count - 1];
  double from_excess = side * (from->*coordinate) - bound;
  for (int k = 0; k < in.count; ++k) {
    const Corner* to = &in[k];
    const double to_excess = side * (to->*coordinate) - bound;
    if ((from_excess > 0) != (to_excess > 0)) {
      const double share = from_excess / (from_excess - to_excess);
      room[count++] = {
          from->x + share * (to->x - from->x), from->y + share * (to->y - from->y),
          from->z + share * (to->z - from->z), to_excess > 0 ? line : from->leaving};
    }
    if (!(to_excess > 0)) room[count++] = *to;
    from = to;
    from_excess = to_excess;
  }
  room.count = count;
  return room;
}

/** The two boxes of a face contact, seen from the one whose face clips. */
struct FacePair {
  const std::array<double, 3>& h_reference;
  const std::array<double, 3>& h_incident;
  std::array<double, 3> centre;  ///< Of the incident box. [m]
  std::array<std::array<double, 3>, 3>
      column;  ///< column[k]: axis k of the incident box.
  BoxFace reference;
};

FacePair SeenFromReference(const BoxPair& pair, const AxisGap& axis) {
  const auto& R = pair.R_AB;
  if (axis.kind == AxisKind::kFaceOfA) {
    const auto& t = pair.p_AB_A;
    return {pair.h_A,
            pair.h_B,
            t,
            {{{R[0][0], R[1][0], R[2][0]},
              {R[0][1], R[1][1], R[2][1]},
              {R[0][2], R[1][2], R[2][2]}}},
            {axis.i, t[static_cast<std::size_t>(axis.i)] < 0 ? 0 : 1}};
  }
  const auto& t = pair.p_AB_B;
  return {pair.h_B,
          pair.h_A,
          {-t[0], -t[1], -t[2]},
          R,
          {axis.j, t[static_cast<std::size_t>(axis.j)] < 0 ? 1 : 0}};
}

/** Returns the corners of the face of the incident box that is most opposed to the
 reference face, and which face that is. */
BoxFace FindIncidentFace(const FacePair& pair, Polygon& face) {
  const auto r = static_cast<std::size_t>(pair.reference.axis);
  const auto r1 = static_cast<std::size_t>(Next(pair.reference.axis));
  const auto r2 = static_cast<std::size_t>(AfterNext(pair.reference.axis));
  const double outward = pair.reference.side == 0 ? -1 : 1;

  int axis = 0;
  if (std::abs(pair.column[1][r]) > std::abs(pair.column[0][r])) axis = 1;
  if (std::abs(pair.column[2][r]) >
      std::abs(pair.column[static_cast<std::size_t>(axis)][r])) {
    axis = 2;
  }
  const auto k = static_cast<std::size_t>(axis);
  const auto k1 = static_cast<std::size_t>(Next(axis));
  const auto k2 = static_cast<std::size_t>(AfterNext(axis));
  const BoxFace incident{axis, outward * pair.column[k][r] < 0 ? 1 : 0};

  const double reach = incident.side == 0 ? -pair.h_incident[k] : pair.h_incident[k];
  const double x = pair.centre[r1] + reach * pair.column[k][r1];
  const double y = pair.centre[r2] + reach * pair.column[k][r2];
  const double z =
      outward * (pair.centre[r] + reach * pair.column[k][r]) - pair.h_reference[r];
  const double x1 = pair.h_incident[k1] * pair.column[k1][r1];
  const double y1 = pair.h_incident[k1] * pair.column[k1][r2];
  const double z1 = outward * (pair.h_incident[k1] * pair.column[k1][r]);
  const double x2 = pair.h_incident[k2] * pair.column[k2][r1];
  const double y2 = pair.h_incident[k2] * pair.column[k2][r2];
  const double z2 = outward * (pair.h_incident[k2] * pair.column[k2][r]);
  face.count = 4;
  face[0] = {x + x1 + x2, y + y1 + y2, z + z1 + z2, 3};
  face[1] = {x - x1 + x2, y - y1 + y2, z - z1 + z2, 0};
  face[2] = {x - x1 - x2, y - y1 - y2, z - z1 - z2, 2};
  face[3] = {x + x1 - x2, y + y1 - y2, z + z1 - z2, 1};
  return incident;
}

}  // namespace

void FillFaceContacts(const BoxPair& pair, const AxisGap& axis, const Pose& X_WA,
                      const Pose& X_WB, Manifold& manifold) {
  const bool reference_is_B = axis.kind == AxisKind::kFaceOfB;
  const FacePair faces = SeenFromReference(pair, axis);
  const auto r = static_cast<std::size_t>(faces.reference.axis);
  const double h_x =
      faces.h_reference[static_cast<std::size_t>(Next(faces.reference.axis))];
  const double h_y =
      faces.h_reference[static_cast<std::size_t>(AfterNext(faces.reference.axis))];

  Polygon face;
  const BoxFace incident = FindIncidentFace(faces, face);

  // Faces that lie flush share corners: rounding must not cut those off, so the lines
  // stand back by the slack, and what they let through is brought back to the face.
  const double slack = kOverlapRounding * pair.Size();
  std::array<Polygon, 4> cut;
  const Polygon& right = Clip<&Corner::x, 1>(face, h_x + slack, 5, cut[0]);
  const Polygon& left = Clip<&Corner::x, -1>(right, h_x + slack, 4, cut[1]);
  const Polygon& upper = Clip<&Corner::y, 1>(left, h_y + slack, 7, cut[2]);
  const Polygon& lower = Clip<&Corner::y, -1>(upper, h_y + slack, 6, cut[3]);
  Polygon deepest;
  if (lower.count == 0) {
    // Only where another axis is as good to within rounding can the faces miss each
    // other.
    deepest[deepest.count++] =
        *std::min_element(face.corners.begin(), face.corners.begin() + face.count,
                          [](const Corner& a, const Corner& b) { return a.z < b.z; });
  }
  const Polygon& polygon = lower.count == 0 ? deepest : lower;

  double least_z = polygon[0].z;
  for (int k = 1; k < polygon.count; ++k) least_z = std::min(least_z, polygon[k].z);
  const double highest = std::max(slack, least_z + slack);

  const Pose& X_WR = reference_is_B ? X_WB : X_WA;
  const double outward = faces.reference.side == 0 ? -1 : 1;
  FaceEdge arriving = polygon[polygon.count - 1].leaving;
  const Corner* kept = nullptr;
  for (int k = 0; k < polygon.count && manifold.count < 8; ++k) {
    const Corner& corner = polygon[k];
    const FaceEdge edge = std::exchange(arriving, corner.leaving);
    if (corner.z > highest) continue;
    // A corner that a line cuts within rounding of its tip leaves two that are one.
    if (kept != nullptr && std::abs(corner.x - kept->x) <= 4 * slack &&
        std::abs(corner.y - kept->y) <= 4 * slack) {
      continue;
    }
    kept = &corner;

    ContactPoint& contact = manifold.contacts[static_cast<std::size_t>(manifold.count++)];
    contact.separation = std::max(corner.z, manifold.separation);
    contact.feature =
        FaceContactId(reference_is_B, faces.reference, incident, edge, corner.leaving);
    Eigen::Vector3d p_RC;
    p_RC[faces.reference.axis] =
        outward * (faces.h_reference[r] + contact.separation / 2);
    p_RC[Next(faces.reference.axis)] = std::clamp(corner.x, -h_x, h_x);
    p_RC[AfterNext(faces.reference.axis)] = std::clamp(corner.y, -h_y, h_y);
    contact.p_WC = X_WR.p_WB + X_WR.R_WB * p_RC;
  }
}

}  // namespace cookbook
