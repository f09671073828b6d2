#include "reports/measures/overlap_along.h"

#include <variant>

#include "reports/referee/referee.h"

namespace touchstone {
namespace {

bool IsHalfSpace(const Body& body) {
  return std::holds_alternative<HalfSpace>(body.shape);
}

}  // namespace

Eigen::Vector3d SupportingDirection(const ContactQuery& query,
                                    const Eigen::Vector3d& n_W) {
  if (IsHalfSpace(query.A)) return query.A.X_WB.R_WB.col(2);
  // B's outward normal points towards A, against n_AB.
  if (IsHalfSpace(query.B)) return -query.B.X_WB.R_WB.col(2);
  return n_W;
}

Enclosure OverlapAlong(const ContactQuery& query, const Eigen::Vector3d& n_W) {
  if (!IsHalfSpace(query.A) && !IsHalfSpace(query.B)) return Overlap(query, n_W);
  const Eigen::Vector3d h_W = SupportingDirection(query, n_W);
  const double tilt = (n_W.normalized() - h_W.normalized()).norm() * SceneSize(query);
  const Enclosure along = Overlap(query, h_W);
  return {along.lo + tilt, along.hi + tilt};
}

}  // namespace touchstone
