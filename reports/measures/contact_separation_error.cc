#include "reports/measures/contact_separation_error.h"

#include <algorithm>

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

}  // namespace touchstone
