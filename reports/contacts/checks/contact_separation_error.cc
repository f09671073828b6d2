#include "reports/contacts/checks/contact_separation_error.h"

#include <algorithm>
#include <vector>

#include "reports/contacts/checks/contact_surface_error.h"
#include "reports/contacts/checks/judged_answer.h"
#include "reports/referee/proved_farther.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

/** Returns how far `body` extends along the unit vector `out_W` from `p_W`, at most as
 far as the scene. */
double Beyond(const Body& body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& out_W,
              double e, double least, double size) {
  const auto is_within = [&](double t) {
    const Eigen::Vector3d q_W = p_W + t * out_W;
    // At most contacts nothing extends further, which doubles prove.
    return !referee::IsProvedFarther(body, q_W, out_W, e) &&
           SignedDistance(body, q_W).hi <= e;
  };
  // The distance is convex along the line, so the line stays within e up to one point.
  if (!is_within(least)) return 0;
  double inside = least;
  double outside = std::max(4 * size, 2 * least);
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = inside + (outside - inside) / 2;
    (is_within(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

double ContactSeparationError(const ContactQuery& query, const WitnessPoints& points,
                              const Eigen::Vector3d& n_AB_W, double e, double least) {
  const double size = SceneSize(query);
  return std::max(Beyond(query.A, points.p_WCa, n_AB_W, e, least, size),
                  Beyond(query.B, points.p_WCb, -n_AB_W, e, least, size));
}

void CheckContactSeparations(JudgedAnswer& judged) {
  if (!judged.points_are_right || !judged.normal_is_right) return;
  const std::vector<PointsOnSurfaces> all = AllPointsOf(judged);
  const double e = judged.tolerances.position;
  const double least = judged.tolerances.across;
  double beyond = 0;
  double gap = 0;
  const PointsOnSurfaces* worst = &all.front();
  for (const PointsOnSurfaces& on : all) {
    if (on.n_W.isZero()) continue;
    const double more = ContactSeparationError(judged.query, on.points, on.n_W, e, least);
    if (more > beyond || (beyond == 0 && on.gap > gap)) worst = &on;
    beyond = std::max(beyond, more);
    gap = std::max(gap, on.gap);
  }
  const bool is_apart = !(beyond > 0 || gap <= e);
  const auto prove = [&]() -> Proof {
    return {.kind = is_apart ? ProofKind::kSurplus : ProofKind::kTooShallow,
            .bound = is_apart ? gap : beyond,
            .points_W = {worst->points.p_WCa, worst->points.p_WCb}};
  };
  const auto because = [&] {
    return is_apart ? judged.because.Separation() : judged.because.Across();
  };
  judged.Judge({MeasureKind::kContactSeparationError, is_apart ? gap : beyond,
                is_apart ? judged.tolerances.separation : least},
               because, prove);
}

}  // namespace touchstone
