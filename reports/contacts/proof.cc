#include "reports/contacts/proof.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "reports/measures/overlap_along.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

double Middle(const Enclosure& e) {
  return e.lo + (e.hi - e.lo) / 2;
}

/** A point inside both shapes. */
struct InsidePoint {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  /** Certified depth of the point inside both shapes. [m] */
  double depth = -std::numeric_limits<double>::infinity();
};

InsidePoint PointInsideBoth(const ContactQuery& query, const ContactTruth& truth) {
  const Certificate& proof = truth.certificate;
  std::vector<Eigen::Vector3d> candidates = {query.A.X_WB.p_WB, query.B.X_WB.p_WB,
                                             (proof.p_WCa + proof.p_WCb) / 2};
  // The patch lies midway through the overlap, so its middle is well inside both.
  const ContactPatch patch =
      PatchAlong(query, proof.n_AB_W, Middle(truth.separation), truth.input_rounding);
  if (!patch.vertices_W.empty()) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& v : patch.vertices_W) sum += v;
    candidates.emplace_back(sum / static_cast<double>(patch.vertices_W.size()));
  }
  InsidePoint best;
  for (const Eigen::Vector3d& p : candidates) {
    const double depth =
        -std::max(SignedDistance(query.A, p).hi, SignedDistance(query.B, p).hi);
    if (depth > best.depth) best = {p, depth};
  }
  return best;
}

/** Makes the certified plane the refutation of `claim`. */
Proof ByPlane(const ContactTruth& truth, Proof claim) {
  const Certificate& certificate = truth.certificate;
  claim.kind = ProofKind::kPlane;
  claim.n_W = certificate.n_AB_W;
  claim.offset = certificate.n_AB_W.dot(certificate.p_WCa + certificate.p_WCb) / 2;
  claim.bound = truth.separation.lo;
  return claim;
}

/** Makes the certified translation the refutation of `claim`. */
Proof ByTranslation(const ContactTruth& truth, Proof claim) {
  claim.kind = ProofKind::kTranslation;
  claim.n_W = truth.certificate.n_AB_W;
  claim.bound = truth.separation.lo;
  return claim;
}

/** Makes the least length of a translation the refutation of `claim`. */
Proof ByNoTranslation(const ContactTruth& truth, Proof claim) {
  claim.kind = ProofKind::kNoTranslation;
  claim.bound = truth.separation.hi;
  return claim;
}

}  // namespace

Proof ProveTouching(const Dispute& dispute) {
  const ContactTruth& truth = dispute.truth;
  if (dispute.answer.touching) return ByPlane(truth, {.claim = ProofClaim::kTouching});
  Proof proof{.kind = ProofKind::kCommonPoint, .claim = ProofClaim::kApart};
  if (truth.separation.hi >= 0) {
    proof.bound = 0;
    proof.points_W = {truth.certificate.p_WCa};
    return proof;
  }
  const InsidePoint inside = PointInsideBoth(dispute.query, truth);
  if (!(inside.depth > 0)) return ByNoTranslation(truth, {.claim = ProofClaim::kApart});
  proof.bound = -inside.depth;
  proof.points_W = {inside.p_W};
  return proof;
}

Proof ProveSeparation(const Dispute& dispute, double separation) {
  const ContactTruth& truth = dispute.truth;
  Proof claim{.claim = ProofClaim::kSeparation, .said = separation};
  if (truth.separation.lo > 0) {
    if (separation < truth.separation.lo) return ByPlane(truth, std::move(claim));
    claim.kind = ProofKind::kNearestPoints;
    claim.bound = truth.separation.hi;
    claim.points_W = {truth.certificate.p_WCa, truth.certificate.p_WCb};
    return claim;
  }
  if (separation < truth.separation.lo) return ByTranslation(truth, std::move(claim));
  if (separation < 0 && dispute.answer.n_AB_W) {
    claim.claimed_W = *dispute.answer.n_AB_W;
    claim.rest = OverlapAlong(dispute.query, claim.claimed_W).lo + separation;
  }
  return ByNoTranslation(truth, std::move(claim));
}

Proof ProveInconsistency(const Dispute& dispute, const Eigen::Vector3d& n_W,
                         double separation) {
  return {.kind = ProofKind::kOverlap,
          .said = separation,
          .bound = -Middle(OverlapAlong(dispute.query, n_W)),
          .claimed_W = n_W};
}

Proof ProveManifoldInconsistency(double separation, const ContactPoint& deepest) {
  return {.kind = ProofKind::kDeepest,
          .said = separation,
          .bound = deepest.separation,
          .points_W = {deepest.p_WC}};
}

Proof ProveExcess(const Dispute& dispute, const Eigen::Vector3d& n_W) {
  const ContactTruth& truth = dispute.truth;
  Proof claim{.claim = ProofClaim::kNormal,
              .said = -OverlapAlong(dispute.query, n_W).lo,
              .claimed_W = n_W};
  return truth.separation.lo > 0 ? ByPlane(truth, std::move(claim))
                                 : ByTranslation(truth, std::move(claim));
}

Proof ProveOppositeNormal(const Dispute& dispute, const Eigen::Vector3d& n_W) {
  return {.kind = ProofKind::kOpposite,
          .said = -Middle(OverlapAlong(dispute.query, -n_W)),
          .bound = -Middle(OverlapAlong(dispute.query, n_W)),
          .claimed_W = n_W};
}

Proof ProveDualityGap(const Dispute& dispute) {
  const WitnessPoints& w = *dispute.answer.witnesses;
  const Eigen::Vector3d p_AB_W = w.p_WCb - w.p_WCa;
  return {.kind = ProofKind::kDuality,
          .said = p_AB_W.norm(),
          .bound = -Middle(OverlapAlong(dispute.query, p_AB_W)),
          .points_W = {w.p_WCa, w.p_WCb}};
}

Proof ProveSurfaceError(const Dispute& dispute, const Eigen::Vector3d& p_WCa,
                        const Eigen::Vector3d& p_WCb) {
  return {.kind = ProofKind::kOffSurfaces,
          .said = std::abs(Middle(SignedDistance(dispute.query.A, p_WCa))),
          .bound = std::abs(Middle(SignedDistance(dispute.query.B, p_WCb))),
          .points_W = {p_WCa, p_WCb}};
}

Proof ProveWitnessError(const Dispute& dispute, const Eigen::Vector3d* n_W,
                        double separation) {
  const WitnessPoints& w = *dispute.answer.witnesses;
  const Eigen::Vector3d p_AB_W = w.p_WCb - w.p_WCa;
  Proof proof{.kind = ProofKind::kWitnesses,
              .said = separation,
              .bound = p_AB_W.norm(),
              .points_W = {w.p_WCa, w.p_WCb}};
  if (n_W == nullptr) return proof;
  proof.claimed_W = *n_W;
  proof.bound = p_AB_W.dot(*n_W);
  proof.rest = (p_AB_W - proof.bound * *n_W).norm();
  return proof;
}

Proof ProveContactTooShallow(const WitnessPoints& points, double more) {
  return {.kind = ProofKind::kTooShallow,
          .bound = more,
          .points_W = {points.p_WCa, points.p_WCb}};
}

Proof ProveSurplusContact(const WitnessPoints& points, double gap) {
  return {.kind = ProofKind::kSurplus,
          .bound = gap,
          .points_W = {points.p_WCa, points.p_WCb}};
}

Proof ProveOffPatch(const ContactPoint& contact, double off) {
  return {.kind = ProofKind::kOffPatch,
          .said = contact.separation,
          .bound = off,
          .points_W = {contact.p_WC}};
}

Proof ProveUnspanned(const Dispute& dispute, const Eigen::Vector3d& p_W,
                     double unspanned) {
  return {.kind = ProofKind::kUnspanned,
          .rest = unspanned,
          .points_W = {p_W},
          .contacts = {dispute.answer.points.size(), 0}};
}

Proof ProveCount(const Dispute& dispute, const ContactPatch& patch) {
  return {.kind = ProofKind::kCount,
          .contacts = {dispute.answer.points.size(),
                       static_cast<std::uint64_t>(patch.least_contacts)}};
}

Proof ProveTooDeep(const Dispute& dispute, const ContactPoint& contact) {
  const ContactTruth& truth = dispute.truth;
  Proof claim{.claim = ProofClaim::kContact,
              .said = contact.separation,
              .points_W = {contact.p_WC}};
  return truth.separation.lo > 0 ? ByPlane(truth, std::move(claim))
                                 : ByTranslation(truth, std::move(claim));
}

Proof ProveMixedNormals(double angle) {
  return {.kind = ProofKind::kMixedNormals, .rest = angle};
}

}  // namespace touchstone
