#include "reports/contacts/checks/contact_too_deep.h"

#include <algorithm>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/refutation.h"
#include "reports/measures/stated.h"

namespace touchstone {

double ContactTooDeep(const ContactTruth& truth, const ContactPoint& contact) {
  return std::max(0.0, truth.separation.lo - contact.separation);
}

void CheckDeepestContact(JudgedAnswer& judged) {
  const ContactPoint* deepest = DeepestOf(judged.answer);
  if (deepest == nullptr) return;
  const auto prove = [&] {
    return ByPlaneOrTranslation(judged.truth, {.claim = ProofClaim::kContact,
                                               .said = deepest->separation,
                                               .points_W = {deepest->p_WC}});
  };
  judged.Judge(
      {.measure = MeasureKind::kContactTooDeep,
       .value = ContactTooDeep(judged.truth, *deepest),
       .tolerance = judged.tolerances.separation,
       .worst = judged.truth.separation.hi - deepest->separation},
      [&] { return judged.because.Separation(); }, prove);
}

}  // namespace touchstone
