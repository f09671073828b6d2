#pragma once

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "reports/finding/proof.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A disputed answer with everything that a proof of its error may cite. */
struct Dispute {
  const ContactQuery& query;
  const ContactTruth& truth;
  const ContactAnswer& answer;
};

/** Each function below returns the proof of an error, given that the measure of that name
 found one. `n_W` is the unit normal of the answer, from A to B. */
Proof ProveTouching(const Dispute& dispute);
Proof ProveSeparation(const Dispute& dispute, double separation);
Proof ProveInconsistency(const Dispute& dispute, const Eigen::Vector3d& n_W,
                         double separation);
Proof ProveManifoldInconsistency(double separation, const ContactPoint& deepest);
Proof ProveExcess(const Dispute& dispute, const Eigen::Vector3d& n_W);
Proof ProveOppositeNormal(const Dispute& dispute, const Eigen::Vector3d& n_W);
Proof ProveDualityGap(const Dispute& dispute);
Proof ProveSurfaceError(const Dispute& dispute, const Eigen::Vector3d& p_WCa,
                        const Eigen::Vector3d& p_WCb);
/** @param n_W The normal of the answer; null if it has none. */
Proof ProveWitnessError(const Dispute& dispute, const Eigen::Vector3d* n_W,
                        double separation);
/** @param more How much deeper the bodies overlap at the contact than it says. [m] */
Proof ProveContactTooShallow(const WitnessPoints& points, double more);
/** @param gap The distance of its two points. [m] */
Proof ProveSurplusContact(const WitnessPoints& points, double gap);
Proof ProveOffPatch(const ContactPoint& contact, double off);
/** @param p_W A point of the patch that the contacts leave out. */
Proof ProveUnspanned(const Dispute& dispute, const Eigen::Vector3d& p_W,
                     double unspanned);
Proof ProveCount(const Dispute& dispute, const ContactPatch& patch);
Proof ProveTooDeep(const Dispute& dispute, const ContactPoint& contact);
Proof ProveMixedNormals(double angle);

}  // namespace touchstone
