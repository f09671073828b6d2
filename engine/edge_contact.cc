#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/box_contacts.h"
#include "engine/feature.h"

namespace cookbook {

void FillEdgeContact(const BoxPair& pair, const AxisGap& axis,
                     const Eigen::Vector3d& n_AB_A, const Pose& X_WA,
                     Manifold& manifold) {
  // Sides are taken by sign, not by branches, which nothing could foretell.
  const auto i = static_cast<std::size_t>(axis.i);
  const auto i1 = static_cast<std::size_t>(Next(axis.i));
  const auto i2 = static_cast<std::size_t>(AfterNext(axis.i));
  const auto j = static_cast<std::size_t>(axis.j);
  const auto j1 = static_cast<std::size_t>(Next(axis.j));
  const auto j2 = static_cast<std::size_t>(AfterNext(axis.j));
  const double* n = n_AB_A.data();
  const Row& b = pair.R_BA[j];
  const Row& b1 = pair.R_BA[j1];
  const Row& b2 = pair.R_BA[j2];

  // The edge of A furthest along the normal, and that of B furthest against it.
  const BoxEdge edge_A{axis.i, !std::signbit(n[i1]), !std::signbit(n[i2])};
  double p_AEa[3];
  p_AEa[i] = 0;
  p_AEa[i1] = std::copysign(pair.h_A[i1], n[i1]);
  p_AEa[i2] = std::copysign(pair.h_A[i2], n[i2]);

  const double n_b1 = n[0] * b1[0] + n[1] * b1[1] + n[2] * b1[2];
  const double n_b2 = n[0] * b2[0] + n[1] * b2[1] + n[2] * b2[2];
  const BoxEdge edge_B{axis.j, std::signbit(n_b1), std::signbit(n_b2)};
  const double to_b1 = -std::copysign(pair.h_B[j1], n_b1);
  const double to_b2 = -std::copysign(pair.h_B[j2], n_b2);
  double p_AEb[3];
  double between[3];
  for (std::size_t k = 0; k < 3; ++k) {
    p_AEb[k] = pair.p_AB_A[k] + to_b1 * b1[k] + to_b2 * b2[k];
    between[k] = p_AEb[k] - p_AEa[k];
  }

  // Nearest points of two lines. Measured across A's edge, B's edge rises by `sine` per
  // length: a nearly parallel pair moves both points along their edges, by rounding /
  // sine, but never apart by more than rounding.
  const double squared_sine = axis.sine * axis.sine;
  const double along_B =
      std::clamp(-(between[i1] * b[i1] + between[i2] * b[i2]) / squared_sine,
                 -pair.h_B[j], pair.h_B[j]);
  p_AEa[i] = std::clamp(between[i] + along_B * b[i], -pair.h_A[i], pair.h_A[i]);

  manifold.count = 1;
  ContactPoint& contact = manifold.contacts[0];
  Eigen::Vector3d p_AC;
  for (std::size_t k = 0; k < 3; ++k) {
    p_AC.data()[k] = 0.5 * (p_AEa[k] + (p_AEb[k] + along_B * b[k]));
  }
  contact.p_WC = X_WA.p_WB + X_WA.R_WB * p_AC;
  contact.separation = manifold.separation;
  contact.feature = EdgeContactId(edge_A, edge_B);
}

}  // namespace cookbook
