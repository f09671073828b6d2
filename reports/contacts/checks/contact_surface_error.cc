#include "reports/contacts/checks/contact_surface_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/refutation.h"
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

std::vector<PointsOnSurfaces> AllPointsOf(const JudgedAnswer& judged) {
  std::vector<PointsOnSurfaces> all;
  const ContactAnswer& answer = judged.answer;
  if (answer.witnesses) {
    const bool has_normal = judged.n_W && answer.touching;
    all.push_back({*answer.witnesses,
                   has_normal ? *judged.n_W : Eigen::Vector3d(Eigen::Vector3d::Zero()),
                   0});
  }
  for (const ContactPoint& contact : answer.points) {
    const Eigen::Vector3d n_W = contact.n_AB_W.value_or(*judged.n_W).normalized();
    all.push_back({SurfacePointsOf(contact, n_W), n_W, contact.separation});
  }
  return all;
}

void CheckSurfacePoints(JudgedAnswer& judged) {
  double largest = -1;
  std::optional<WitnessPoints> worst;
  for (const PointsOnSurfaces& on : AllPointsOf(judged)) {
    const double error = SurfaceError(judged.query, on.points);
    if (!(error <= largest)) {
      largest = error;
      worst = on.points;
    }
  }
  if (!worst) return;
  const auto prove = [&]() -> Proof {
    return {.kind = ProofKind::kOffSurfaces,
            .said = std::abs(MiddleOf(SignedDistance(judged.query.A, worst->p_WCa))),
            .bound = std::abs(MiddleOf(SignedDistance(judged.query.B, worst->p_WCb))),
            .points_W = {worst->p_WCa, worst->p_WCb}};
  };
  const Verdict verdict = judged.Judge(
      {MeasureKind::kContactSurfaceError, largest, judged.tolerances.separation},
      [&] { return judged.because.Separation(); }, prove);
  judged.points_are_right = verdict == Verdict::kPass;
}

}  // namespace touchstone
