#include "engine/dynamics/face_patch.h"

#include <array>
#include <cmath>

#include "engine/feature.h"

namespace cookbook {
namespace {

/** A corner of the incident face while it is clipped, in the reference frame: x and y
 along the reference face from its centre, z above it. [m] */
struct Corner {
  double x;
  double y;
  double z;
  FaceEdge next;  ///< The edge from this corner to the one after it.
};

/** Corners in order; clipping a quadrangle by four lines leaves no more than eight. */
struct Polygon {
  std::array<Corner, 8> corners;
  int count = 0;

  void Add(const Corner& corner) {
    if (count < 8) corners[static_cast<std::size_t>(count++)] = corner;
  }
};

/** Keeps what has sign · coordinate <= bound; the cut is named `edge`. */
Polygon Clip(const Polygon& polygon, double Corner::*coordinate, double sign,
             double bound, FaceEdge edge) {
  Polygon kept;
  for (int i = 0; i < polygon.count; ++i) {
    const Corner& a = polygon.corners[static_cast<std::size_t>(i)];
    const Corner& b =
        polygon.corners[static_cast<std::size_t>(i + 1 == polygon.count ? 0 : i + 1)];
    const double out_a = sign * a.*coordinate - bound;
    const double out_b = sign * b.*coordinate - bound;
    if (out_a <= 0) kept.Add(a);
    if ((out_a <= 0) == (out_b <= 0)) continue;
    const double t = out_a / (out_a - out_b);
    Corner cut{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z),
               out_a <= 0 ? edge : a.next};
    cut.*coordinate = sign * bound;
    kept.Add(cut);
  }
  return kept;
}

}  // namespace

FaceOfBox FaceTowards(const Eigen::Vector3d& n_W, const Eigen::Matrix3d& R_WB) {
  const Eigen::Vector3d n_B = R_WB.transpose() * n_W;
  FaceOfBox face;
  n_B.cwiseAbs().maxCoeff(&face.axis);
  face.side = n_B[face.axis] < 0 ? -1 : 1;
  return face;
}

void FillFacePatch(double margin, const FaceOfBox& face, const Box& reference,
                   const Pose& X_WR, const Box& incident, const Pose& X_WI,
                   bool reference_is_B, Manifold& manifold) {
  const int r1 = (face.axis + 1) % 3;
  const int r2 = (face.axis + 2) % 3;
  const Eigen::Vector3d n_W = face.side * X_WR.R_WB.col(face.axis);
  const FaceOfBox opposed = FaceTowards(-n_W, X_WI.R_WB);
  const int i1 = (opposed.axis + 1) % 3;
  const int i2 = (opposed.axis + 2) % 3;

  Eigen::Matrix3d seen;  // Rows: x, y, z of the reference face in the world.
  seen.row(0) = X_WR.R_WB.col(r1);
  seen.row(1) = X_WR.R_WB.col(r2);
  seen.row(2) = n_W;
  Eigen::Vector3d centre = seen * (X_WI.p_WB - X_WR.p_WB +
                                   opposed.side * incident.half_extents[opposed.axis] *
                                       X_WI.R_WB.col(opposed.axis));
  centre[2] -= reference.half_extents[face.axis];
  const Eigen::Vector3d u = seen * (incident.half_extents[i1] * X_WI.R_WB.col(i1));
  const Eigen::Vector3d v = seen * (incident.half_extents[i2] * X_WI.R_WB.col(i2));

  Polygon polygon;
  const auto add = [&](double su, double sv, FaceEdge next) {
    polygon.Add({centre[0] + su * u[0] + sv * v[0], centre[1] + su * u[1] + sv * v[1],
                 centre[2] + su * u[2] + sv * v[2], next});
  };
  add(-1, -1, 0);
  add(1, -1, 1);
  add(1, 1, 2);
  add(-1, 1, 3);
  const double h_x = reference.half_extents[r1];
  const double h_y = reference.half_extents[r2];
  polygon = Clip(polygon, &Corner::x, -1, h_x, 4);
  polygon = Clip(polygon, &Corner::x, 1, h_x, 5);
  polygon = Clip(polygon, &Corner::y, -1, h_y, 6);
  polygon = Clip(polygon, &Corner::y, 1, h_y, 7);

  const BoxFace reference_face{face.axis, face.side > 0};
  const BoxFace incident_face{opposed.axis, opposed.side > 0};
  manifold.count = 0;
  for (int i = 0; i < polygon.count; ++i) {
    const Corner& corner = polygon.corners[static_cast<std::size_t>(i)];
    if (corner.z > margin) continue;
    const Corner& before =
        polygon.corners[static_cast<std::size_t>(i == 0 ? polygon.count - 1 : i - 1)];
    ContactPoint& contact = manifold.contacts[static_cast<std::size_t>(manifold.count++)];
    const Eigen::Vector3d p_R(corner.x, corner.y,
                              corner.z + reference.half_extents[face.axis]);
    contact.p_WC = X_WR.p_WB + seen.transpose() * p_R;
    contact.separation = corner.z;
    contact.feature = FaceContactId(reference_is_B, reference_face, incident_face,
                                    before.next, corner.next);
  }
}

}  // namespace cookbook
