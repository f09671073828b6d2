#include "reports/contacts/checks/consistency_error.h"

#include <algorithm>
#include <cmath>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/refutation.h"
#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"
#include "reports/measures/stated.h"

namespace touchstone {

double ConsistencyError(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation) {
  return ConsistencyError(OverlapAlong(query, n_W), separation);
}

double ConsistencyError(const Enclosure& overlap, double separation) {
  return Outside(-separation, overlap);
}

double ManifoldInconsistency(std::span<const ContactPoint> contacts, double separation) {
  if (contacts.empty()) return 0;
  double deepest = contacts.front().separation;
  for (const ContactPoint& contact : contacts)
    deepest = std::min(deepest, contact.separation);
  return std::abs(deepest - separation);
}

void CheckConsistency(JudgedAnswer& judged) {
  // Without a normal there are no contacts either: they would have one.
  if (!judged.separation || !judged.n_W) return;
  const double said = *judged.separation;
  const double along = ConsistencyError(judged.Along(), said);
  const double unmet = ManifoldInconsistency(judged.answer.points, said);
  const auto prove = [&]() -> Proof {
    if (along >= unmet)
      return {.kind = ProofKind::kOverlap,
              .said = said,
              .bound = -MiddleOf(judged.Along()),
              .claimed_W = *judged.n_W};
    const ContactPoint& deepest = *DeepestOf(judged.answer);
    return {.kind = ProofKind::kDeepest,
            .said = said,
            .bound = deepest.separation,
            .points_W = {deepest.p_WC}};
  };
  judged.Judge(
      {MeasureKind::kConsistencyError, std::max(along, unmet), judged.tolerances.apart},
      [&] { return judged.because.Apart(); }, prove);
}

}  // namespace touchstone
