#include "reports/contacts/checks/missed_point.h"

#include "reports/contacts/checks/contact_surface_error.h"
#include "reports/contacts/checks/patch_coverage.h"

namespace touchstone {

std::optional<Eigen::Vector3d> CertainlyMissed(
    const ContactQuery& query, const ContactPatch& patch, const Eigen::Vector3d& n_W,
    double separation, std::span<const ContactPoint> contacts, double legal, double e) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : patch.vertices_W)
    middle += corner / static_cast<double>(patch.vertices_W.size());
  for (const double drawn : {1.0, 0.98, 0.96, 0.94, 0.92, 0.9}) {
    for (const Eigen::Vector3d& corner : patch.vertices_W) {
      const Eigen::Vector3d p_W = middle + drawn * (corner - middle);
      if (UnspannedAt(p_W, patch, n_W, contacts) <= legal) continue;
      const WitnessPoints points = SurfacePointsOf({p_W, separation, {}}, n_W);
      if (SurfaceError(query, points) <= 2 * e) return p_W;
    }
  }
  return std::nullopt;
}

}  // namespace touchstone
