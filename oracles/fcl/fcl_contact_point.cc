#include "oracles/fcl/fcl_contact_point.h"

#include <variant>

namespace touchstone {

Eigen::Vector3d MidwayPoint(const ContactQuery& query, const FclContact& contact) {
  const auto* A = std::get_if<Sphere>(&query.A.shape);
  const auto* B = std::get_if<Sphere>(&query.B.shape);
  if (A == nullptr || B == nullptr) return contact.p_W;
  const double share = A->radius / (A->radius + B->radius);
  return contact.p_W + (share - 0.5) * contact.depth * contact.n_AB_W;
}

}  // namespace touchstone
