#pragma once

#include <string>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A disputed answer with everything that a proof of its error may cite. */
struct Dispute {
  const std::string& oracle;
  const ContactQuery& query;
  const ContactTruth& truth;
  const ContactAnswer& answer;
};

/** Each function below returns one sentence with numbers that a person can check by hand,
 given that the measure of that name found an error. Lengths are in m with nine digits, or
 with as many more as distinguish two of them. Points, directions and planes have all
 digits: they read back as the exact doubles. `n_W` is the unit normal of the answer, from
 A to B. */
std::string ProveTouching(const Dispute& dispute);
std::string ProveSeparation(const Dispute& dispute, double separation);
std::string ProveInconsistency(const Dispute& dispute, const Eigen::Vector3d& n_W,
                               double separation);
std::string ProveManifoldInconsistency(const Dispute& dispute, double separation,
                                       const ContactPoint& deepest);
std::string ProveExcess(const Dispute& dispute, const Eigen::Vector3d& n_W);
std::string ProveOppositeNormal(const Dispute& dispute, const Eigen::Vector3d& n_W);
std::string ProveDualityGap(const Dispute& dispute);
std::string ProveSurfaceError(const Dispute& dispute, const Eigen::Vector3d& p_WCa,
                              const Eigen::Vector3d& p_WCb);
/** @param n_W The normal of the answer; null if it has none. */
std::string ProveWitnessError(const Dispute& dispute, const Eigen::Vector3d* n_W,
                              double separation);
/** @param more How much deeper the bodies overlap at the contact than it says. [m] */
std::string ProveContactTooShallow(const Dispute& dispute, const WitnessPoints& points,
                                   double more);
/** @param gap The distance of its two points. [m] */
std::string ProveSurplusContact(const Dispute& dispute, const WitnessPoints& points,
                                double gap);
std::string ProveOffPatch(const Dispute& dispute, const ContactPoint& contact,
                          double off);
/** @param p_W A point of the patch that the contacts leave out. */
std::string ProveUnspanned(const Dispute& dispute, const Eigen::Vector3d& p_W,
                           double unspanned);
std::string ProveCount(const Dispute& dispute, const ContactPatch& patch);
std::string ProveTooDeep(const Dispute& dispute, const ContactPoint& contact);
std::string ProveMixedNormals(const Dispute& dispute, double angle);

}  // namespace touchstone
