#include "reports/measures/contact_surface_error.h"

#include <algorithm>

#include "reports/measures/outside.h"
#include "reports/referee/referee.h"

namespace touchstone {

double ContactSurfaceError(const ContactQuery& query, const Eigen::Vector3d& n_AB_W,
                           const ContactPoint& contact) {
  const Eigen::Vector3d n = contact.n_AB_W.value_or(n_AB_W).normalized();
  const Eigen::Vector3d half = n * (contact.separation / 2);
  return WitnessSurfaceError(query, {contact.p_WC - half, contact.p_WC + half});
}

double WitnessSurfaceError(const ContactQuery& query, const WitnessPoints& witnesses) {
  return std::max(Outside(0, SignedDistance(query.A, witnesses.p_WCa)),
                  Outside(0, SignedDistance(query.B, witnesses.p_WCb)));
}

}  // namespace touchstone
