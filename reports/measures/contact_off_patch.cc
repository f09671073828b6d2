#include "reports/measures/contact_off_patch.h"

#include "reports/measures/convex_polygon.h"

namespace touchstone {

double ContactOffPatch(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                       const ContactPoint& contact) {
  const std::vector<Eigen::Vector2d> corners = ProjectedAlong(n_AB_W, patch.vertices_W);
  const std::vector<Eigen::Vector2d> point =
      ProjectedAlong(n_AB_W, std::span(&contact.p_WC, 1));
  return DistanceFrom(ConvexHullOf(corners), point.front());
}

Eigen::Vector3d OffsetFromPatch(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                                const ContactPoint& contact) {
  const std::vector<Eigen::Vector2d> corners = ProjectedAlong(n_AB_W, patch.vertices_W);
  const std::vector<Eigen::Vector2d> point =
      ProjectedAlong(n_AB_W, std::span(&contact.p_WC, 1));
  return LiftedAcross(n_AB_W, OffsetFrom(ConvexHullOf(corners), point.front()));
}

}  // namespace touchstone
