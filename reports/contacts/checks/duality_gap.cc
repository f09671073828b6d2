#include "reports/contacts/checks/duality_gap.h"

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/refutation.h"
#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"

namespace touchstone {

double DualityGap(const ContactQuery& query, const WitnessPoints& witnesses) {
  const Eigen::Vector3d p_AB_W = witnesses.p_WCb - witnesses.p_WCa;
  return Outside(-p_AB_W.norm(), OverlapAlong(query, p_AB_W));
}

void CheckDualityGap(JudgedAnswer& judged) {
  const bool is_apart = judged.truth.separation.lo > 0 && !judged.answer.touching;
  if (!is_apart || !judged.answer.witnesses) return;
  const WitnessPoints& w = *judged.answer.witnesses;
  if (w.p_WCa == w.p_WCb) return;
  const auto prove = [&]() -> Proof {
    const Eigen::Vector3d p_AB_W = w.p_WCb - w.p_WCa;
    return {.kind = ProofKind::kDuality,
            .said = p_AB_W.norm(),
            .bound = -MiddleOf(OverlapAlong(judged.query, p_AB_W)),
            .points_W = {w.p_WCa, w.p_WCb}};
  };
  judged.Judge(
      {MeasureKind::kDualityGap, DualityGap(judged.query, w), judged.tolerances.apart},
      [&] { return judged.because.Apart(); }, prove);
}

}  // namespace touchstone
