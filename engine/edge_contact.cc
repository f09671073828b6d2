#include <algorithm>

#include "engine/box_contacts.h"
#include "engine/feature.h"

namespace cookbook {

void FillEdgeContact(const BoxPair& pair, const AxisGap& axis,
                     const Eigen::Vector3d& n_AB_A, const Pose& X_WA,
                     Manifold& manifold) {
  const Eigen::Vector3d p_AB_A(pair.p_AB_A[0], pair.p_AB_A[1], pair.p_AB_A[2]);
  const auto h_A = [&](int k) { return pair.h_A[static_cast<std::size_t>(k)]; };
  const auto h_B = [&](int k) { return pair.h_B[static_cast<std::size_t>(k)]; };
  const auto b_A = [&](int k) {
    const auto j = static_cast<std::size_t>(k);
    return Eigen::Vector3d(pair.R_AB[0][j], pair.R_AB[1][j], pair.R_AB[2][j]);
  };

  // The edge of A furthest along the normal, and that of B furthest against it.
  const int i1 = Next(axis.i);
  const int i2 = AfterNext(axis.i);
  const BoxEdge edge_A{axis.i, n_AB_A[i1] >= 0, n_AB_A[i2] >= 0};
  Eigen::Vector3d p_AEa = Eigen::Vector3d::Zero();
  p_AEa[i1] = edge_A.side1 ? h_A(i1) : -h_A(i1);
  p_AEa[i2] = edge_A.side2 ? h_A(i2) : -h_A(i2);

  const int j1 = Next(axis.j);
  const int j2 = AfterNext(axis.j);
  const BoxEdge edge_B{axis.j, n_AB_A.dot(b_A(j1)) < 0, n_AB_A.dot(b_A(j2)) < 0};
  const Eigen::Vector3d p_AEb = p_AB_A + (edge_B.side1 ? h_B(j1) : -h_B(j1)) * b_A(j1) +
                                (edge_B.side2 ? h_B(j2) : -h_B(j2)) * b_A(j2);

  // Nearest points of two lines. Measured across A's edge, B's edge rises by `sine` per
  // length: a nearly parallel pair moves both points along their edges, by rounding /
  // sine, but never apart by more than rounding.
  const Eigen::Vector3d between = p_AEb - p_AEa;
  const Eigen::Vector3d b = b_A(axis.j);
  const double squared_sine = axis.sine * axis.sine;
  double along_B = -(between[i1] * b[i1] + between[i2] * b[i2]) / squared_sine;
  along_B = std::clamp(along_B, -h_B(axis.j), h_B(axis.j));
  const double along_A =
      std::clamp(between[axis.i] + along_B * b[axis.i], -h_A(axis.i), h_A(axis.i));
  p_AEa[axis.i] = along_A;

  manifold.count = 1;
  ContactPoint& contact = manifold.contacts[0];
  contact.p_WC = X_WA.p_WB + X_WA.R_WB * (0.5 * (p_AEa + (p_AEb + along_B * b)));
  contact.separation = manifold.separation;
  contact.feature = EdgeContactId(edge_A, edge_B);
}

}  // namespace cookbook
