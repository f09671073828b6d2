#include "reports/contacts/checks/refutation.h"

#include <utility>

namespace touchstone {

double MiddleOf(const Enclosure& enclosure) {
  return enclosure.lo + (enclosure.hi - enclosure.lo) / 2;
}

Proof ByPlane(const ContactTruth& truth, Proof claim) {
  const Certificate& certificate = truth.certificate;
  claim.kind = ProofKind::kPlane;
  claim.n_W = certificate.n_AB_W;
  claim.offset = certificate.n_AB_W.dot(certificate.p_WCa + certificate.p_WCb) / 2;
  claim.bound = truth.separation.lo;
  return claim;
}

Proof ByTranslation(const ContactTruth& truth, Proof claim) {
  claim.kind = ProofKind::kTranslation;
  claim.n_W = truth.certificate.n_AB_W;
  claim.bound = truth.separation.lo;
  return claim;
}

Proof ByNoTranslation(const ContactTruth& truth, Proof claim) {
  claim.kind = ProofKind::kNoTranslation;
  claim.bound = truth.separation.hi;
  return claim;
}

Proof ByPlaneOrTranslation(const ContactTruth& truth, Proof claim) {
  return truth.separation.lo > 0 ? ByPlane(truth, std::move(claim))
                                 : ByTranslation(truth, std::move(claim));
}

}  // namespace touchstone
