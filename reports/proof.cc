#include "reports/proof.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "reports/measures/overlap_along.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

double Middle(const Enclosure& e) {
  return e.lo + (e.hi - e.lo) / 2;
}

/** A point inside both shapes, and how deep inside both it certainly is. */
struct InsidePoint {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  double depth = -std::numeric_limits<double>::infinity();  ///< [m]
};

InsidePoint PointInsideBoth(const ContactQuery& query, const ContactTruth& truth) {
  const Certificate& proof = truth.certificate;
  std::vector<Eigen::Vector3d> candidates = {query.A.X_WB.p_WB, query.B.X_WB.p_WB,
                                             (proof.p_WCa + proof.p_WCb) / 2};
  // The patch lies midway through the overlap; its middle is well inside.
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

std::string SeparatingPlane(const ContactTruth& truth) {
  const Certificate& proof = truth.certificate;
  const double c = proof.n_AB_W.dot(proof.p_WCa + proof.p_WCb) / 2;
  return fmt::format("the plane n·x = {:.9g} with n = {} separates them by {:.9g} m", c,
                     InWords(proof.n_AB_W), truth.separation.lo);
}

std::string LeastTranslation(const ContactTruth& truth) {
  return fmt::format("moving B by {:.9g} m along {} separates them", -truth.separation.lo,
                     InWords(truth.certificate.n_AB_W));
}

}  // namespace

std::string InWords(const Eigen::Vector3d& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

std::string ProveTouching(const Dispute& dispute) {
  if (dispute.answer.touching) {
    return fmt::format("{} says they touch; {}.", dispute.oracle,
                       SeparatingPlane(dispute.truth));
  }
  const InsidePoint inside = PointInsideBoth(dispute.query, dispute.truth);
  if (inside.depth > 0) {
    return fmt::format("{} says apart; the point {} lies {:.9g} m inside both.",
                       dispute.oracle, InWords(inside.p_W), inside.depth);
  }
  return fmt::format(
      "{} says apart; no translation shorter than {:.9g} m separates them.",
      dispute.oracle, -dispute.truth.separation.hi);
}

std::string ProveSeparation(const Dispute& dispute, double separation) {
  const ContactTruth& truth = dispute.truth;
  if (truth.separation.lo > 0) {
    if (separation < truth.separation.lo) {
      return fmt::format("{} says {:.9g} m apart; {}.", dispute.oracle, separation,
                         SeparatingPlane(truth));
    }
    return fmt::format(
        "{} says {:.9g} m apart; the point {} of A and the point {} of B are {:.9g} m "
        "apart.",
        dispute.oracle, separation, InWords(truth.certificate.p_WCa),
        InWords(truth.certificate.p_WCb), truth.separation.hi);
  }
  if (separation < truth.separation.lo) {
    return fmt::format("{} says {:.9g} m deep; {}.", dispute.oracle, -separation,
                       LeastTranslation(truth));
  }
  std::string sentence = fmt::format(
      "{} says {:.9g} m {}; no translation shorter than {:.9g} m separates them",
      dispute.oracle, std::abs(separation), separation < 0 ? "deep" : "apart",
      -truth.separation.hi);
  if (separation < 0 && dispute.answer.n_AB_W) {
    const double left =
        OverlapAlong(dispute.query, *dispute.answer.n_AB_W).lo + separation;
    sentence += fmt::format(
        ", and moving B by {:.9g} m along its own normal {} leaves an overlap of {:.9g} "
        "m",
        -separation, InWords(*dispute.answer.n_AB_W), left);
  }
  return sentence + ".";
}

std::string ProveInconsistency(const Dispute& dispute, const Eigen::Vector3d& n_W,
                               double separation) {
  return fmt::format("{} says {:.9g} m along {}; the overlap along it is {:.9g} m.",
                     dispute.oracle, -separation, InWords(n_W),
                     Middle(OverlapAlong(dispute.query, n_W)));
}

std::string ProveExcess(const Dispute& dispute, const Eigen::Vector3d& n_W) {
  const double along = OverlapAlong(dispute.query, n_W).lo;
  if (dispute.truth.separation.lo > 0) {
    return fmt::format("{} says n = {}, along which the gap is {:.9g} m; {}.",
                       dispute.oracle, InWords(n_W), -along,
                       SeparatingPlane(dispute.truth));
  }
  return fmt::format("{} says n = {}, along which B must move {:.9g} m; {}.",
                     dispute.oracle, InWords(n_W), along,
                     LeastTranslation(dispute.truth));
}

std::string ProveDualityGap(const Dispute& dispute) {
  const WitnessPoints& w = *dispute.answer.witnesses;
  const Eigen::Vector3d p_AB_W = w.p_WCb - w.p_WCa;
  return fmt::format(
      "{} says {} of A and {} of B are nearest; they are {:.9g} m apart, but the gap "
      "along "
      "their direction is {:.9g} m.",
      dispute.oracle, InWords(w.p_WCa), InWords(w.p_WCb), p_AB_W.norm(),
      -Middle(OverlapAlong(dispute.query, p_AB_W)));
}

std::string ProveSurfaceError(const Dispute& dispute, const Eigen::Vector3d& p_WCa,
                              const Eigen::Vector3d& p_WCb) {
  return fmt::format(
      "{} puts a contact at {} on A and {} on B; these are {:.9g} m and {:.9g} m from "
      "the "
      "surfaces.",
      dispute.oracle, InWords(p_WCa), InWords(p_WCb),
      Middle(SignedDistance(dispute.query.A, p_WCa)),
      Middle(SignedDistance(dispute.query.B, p_WCb)));
}

std::string ProveOffPatch(const Dispute& dispute, const ContactPoint& contact,
                          double off) {
  return fmt::format(
      "{} puts a contact {:.9g} m deep at {}; the shapes overlap that deep only {:.9g} m "
      "from "
      "there, across the normal.",
      dispute.oracle, -contact.separation, InWords(contact.p_WC), off);
}

std::string ProveUnspanned(const Dispute& dispute, const ContactPatch& patch,
                           double unspanned) {
  return fmt::format(
      "{} gives {} contacts that leave {:.0f} % of the patch's extent unspanned; one of "
      "its {} "
      "corners is {}.",
      dispute.oracle, dispute.answer.points.size(), 100 * unspanned,
      patch.vertices_W.size(), InWords(patch.vertices_W.front()));
}

std::string ProveCount(const Dispute& dispute, const ContactPatch& patch) {
  return fmt::format("{} gives {} contacts; {} different ones span the patch.",
                     dispute.oracle, dispute.answer.points.size(), patch.least_contacts);
}

std::string ProveTooDeep(const Dispute& dispute, const ContactPoint& contact) {
  return fmt::format("{} gives a contact {:.9g} m deep at {}; {}.", dispute.oracle,
                     -contact.separation, InWords(contact.p_WC),
                     dispute.truth.separation.lo > 0 ? SeparatingPlane(dispute.truth)
                                                     : LeastTranslation(dispute.truth));
}

std::string ProveMixedNormals(const Dispute& dispute, double angle) {
  return fmt::format("{} gives normals {:.9g} rad apart in one manifold.", dispute.oracle,
                     angle);
}

}  // namespace touchstone
