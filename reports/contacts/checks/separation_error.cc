#include "reports/contacts/checks/separation_error.h"

#include <algorithm>
#include <utility>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/refutation.h"
#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"

namespace touchstone {
namespace {

Proof Refuted(const JudgedAnswer& judged, double separation) {
  const ContactTruth& truth = judged.truth;
  Proof claim{.claim = ProofClaim::kSeparation, .said = separation};
  if (separation < truth.separation.lo)
    return ByPlaneOrTranslation(truth, std::move(claim));
  if (truth.separation.lo > 0) {
    claim.kind = ProofKind::kNearestPoints;
    claim.bound = truth.separation.hi;
    claim.points_W = {truth.certificate.p_WCa, truth.certificate.p_WCb};
    return claim;
  }
  if (separation < 0 && judged.answer.n_AB_W) {
    claim.claimed_W = *judged.answer.n_AB_W;
    claim.rest = OverlapAlong(judged.query, claim.claimed_W).lo + separation;
  }
  return ByNoTranslation(truth, std::move(claim));
}

}  // namespace

double SeparationError(const ContactTruth& truth, double separation) {
  return Outside(separation, truth.separation);
}

void CheckSeparation(JudgedAnswer& judged) {
  if (!judged.separation) return;
  const double said = *judged.separation;
  const Enclosure& truth = judged.truth.separation;
  judged.Judge(
      {.measure = MeasureKind::kSeparationError,
       .value = SeparationError(judged.truth, said),
       .tolerance = judged.tolerances.separation,
       .worst = std::max(said - truth.lo, truth.hi - said)},
      [&] { return judged.because.Separation(); }, [&] { return Refuted(judged, said); });
}

}  // namespace touchstone
