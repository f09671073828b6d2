#include "reports/measures/contact_surface_error.h"

#include <algorithm>

#include "reports/measures/outside.h"
#include "reports/referee/referee.h"

namespace touchstone {

WitnessPoints SurfacePointsOf(const ContactPoint& contact,
                              const Eigen::Vector3d& n_AB_W) {
  const Eigen::Vector3d half = n_AB_W * (contact.separation / 2);
  return {contact.p_WC - half, contact.p_WC + half};
}

double SurfaceError(const ContactQuery& query, const WitnessPoints& points) {
  return std::max(Outside(0, SignedDistance(query.A, points.p_WCa)),
                  Outside(0, SignedDistance(query.B, points.p_WCb)));
}

}  // namespace touchstone
