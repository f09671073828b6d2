#include "reports/contacts/checks/contact_off_patch.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/contacts/body_size.h"
#include "reports/contacts/checks/judged_answer.h"
#include "reports/measures/convex_polygon.h"
#include "reports/measures/overlap_along.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

/** A rim that may be the deepest feature, and how wide its deepest part is. */
struct WidestRim {
  double width = 0;  ///< [m]
  double lean = -1;  ///< Sine of the angle to the normal; negative without a rim. [-]
};

/** Returns the rim whose deepest part is the widest. Along a rim of radius r that leans
 by θ the depth falls by only w² sin θ / 2r at the distance w. A depth off by `e` [m]
 therefore leaves w = √(2 e r / sin θ) uncertain, at most the whole rim. */
WidestRim WidestUncertainRim(const ContactQuery& query, const Eigen::Vector3d& n_W,
                             double e) {
  WidestRim widest;
  for (const Body* body : {&query.A, &query.B}) {
    const ShapeKind kind = KindOf(body->shape);
    if (kind != ShapeKind::kCylinder && kind != ShapeKind::kCone) continue;
    const double lean = n_W.cross(body->X_WB.R_WB.col(2)).norm();
    const double r = BoundingRadius(body->shape);
    const double open = lean * r > e ? std::sqrt(2 * e * r / lean) : 2 * r;
    const double most = std::min(2 * r, SmallerExtent(query));
    const double width = std::min(2 * open, most);
    if (width >= widest.width) widest = {width, lean};
  }
  return widest;
}

}  // namespace

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

void CheckContactsInPatch(JudgedAnswer& judged) {
  const ContactAnswer& answer = judged.answer;
  const Enclosure& truth = judged.truth.separation;
  const double e = judged.tolerances.separation;
  const bool applies = !answer.points.empty() && answer.touching &&
                       judged.normal_is_right && truth.hi - truth.lo <= e;
  if (!applies) return;
  // A contact as deep as the deepest to within e lies within √(2 e L) of the features
  // that are within √(2 e L) of the supporting plane, where L is the size of the scene.
  const Eigen::Vector3d n_W = SupportingDirection(judged.query, *judged.n_W);
  const ContactPatch patch = PatchAlong(judged.query, n_W, judged.SupportedSeparation(),
                                        judged.tolerances.across / 2);
  if (patch.vertices_W.empty()) return;
  double off = -1;
  const ContactPoint* worst = nullptr;
  for (const ContactPoint& contact : answer.points) {
    if (contact.separation > truth.hi + e) continue;
    const double distance = ContactOffPatch(patch, *judged.n_W, contact);
    if (!(distance <= off)) {
      off = distance;
      worst = &contact;
    }
  }
  if (worst == nullptr) return;
  const WidestRim rim =
      WidestUncertainRim(judged.query, *judged.n_W, judged.tolerances.position);
  const auto because = [&] {
    return rim.lean < 0 ? judged.because.Across()
                        : fmt::format("{}, or along a rim that leans by {:.2g}",
                                      judged.because.Across(), rim.lean);
  };
  // A contact at the greatest depth whose points lie on both surfaces is in the patch by
  // definition. The polygon is computed in doubles, and proves nothing against it.
  judged.Judge({.measure = MeasureKind::kContactOffPatch,
                .value = off,
                .tolerance = std::max(judged.tolerances.across, rim.width),
                .unproved = judged.points_are_right
                                ? "its points are certified to lie on both surfaces"
                                : ""},
               because, [&]() -> Proof {
                 return {.kind = ProofKind::kOffPatch,
                         .said = worst->separation,
                         .bound = off,
                         .points_W = {worst->p_WC}};
               });
}

}  // namespace touchstone
