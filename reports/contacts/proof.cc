#include "reports/contacts/proof.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "reports/measures/overlap_along.h"
#include "reports/referee/referee.h"
#include "reports/text/counted.h"
#include "reports/text/format_vector.h"
#include "reports/text/told_apart.h"

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

constexpr int kDigits = 9;

std::string InMetres(double length) {
  return fmt::format("{:.{}g}", length, kDigits);
}

// `gap` is truth.separation.lo as text. [m]
std::string SeparatingPlane(const ContactTruth& truth, std::string_view gap) {
  const Certificate& proof = truth.certificate;
  const double c = proof.n_AB_W.dot(proof.p_WCa + proof.p_WCb) / 2;
  return fmt::format("the plane n·x = {} with n = {} separates them by {} m", c,
                     FormatVector(proof.n_AB_W), gap);
}

// `depth` is -truth.separation.lo as text. [m]
std::string LeastTranslation(const ContactTruth& truth, std::string_view depth) {
  return fmt::format("moving B by {} m along {} separates them", depth,
                     FormatVector(truth.certificate.n_AB_W));
}

}  // namespace

std::string ProveTouching(const Dispute& dispute) {
  if (dispute.answer.touching) {
    return fmt::format(
        "{} says they touch; {}.", dispute.oracle,
        SeparatingPlane(dispute.truth, InMetres(dispute.truth.separation.lo)));
  }
  if (dispute.truth.separation.hi >= 0) {
    return fmt::format("{} says apart; the point {} belongs to both.", dispute.oracle,
                       FormatVector(dispute.truth.certificate.p_WCa));
  }
  const InsidePoint inside = PointInsideBoth(dispute.query, dispute.truth);
  if (inside.depth > 0) {
    return fmt::format("{} says apart; the point {} lies {:.9g} m inside both.",
                       dispute.oracle, FormatVector(inside.p_W), inside.depth);
  }
  return fmt::format(
      "{} says apart; no translation shorter than {:.9g} m separates them.",
      dispute.oracle, -dispute.truth.separation.hi);
}

std::string ProveSeparation(const Dispute& dispute, double separation) {
  const ContactTruth& truth = dispute.truth;
  if (truth.separation.lo > 0) {
    if (separation < 0) {
      return fmt::format("{} says {} m deep; {}.", dispute.oracle, InMetres(-separation),
                         SeparatingPlane(truth, InMetres(truth.separation.lo)));
    }
    if (separation < truth.separation.lo) {
      const auto [said, gap, more] = TellApart(separation, truth.separation.lo, kDigits);
      return fmt::format("{} says {} m apart; {}, {} m more.", dispute.oracle, said,
                         SeparatingPlane(truth, gap), more);
    }
    const auto [said, gap, less] = TellApart(separation, truth.separation.hi, kDigits);
    return fmt::format(
        "{} says {} m apart; the point {} of A and the point {} of B are {} m apart, {} "
        "m less.",
        dispute.oracle, said, FormatVector(truth.certificate.p_WCa),
        FormatVector(truth.certificate.p_WCb), gap, less);
  }
  if (separation < truth.separation.lo) {
    const auto [said, depth, less] =
        TellApart(-separation, -truth.separation.lo, kDigits);
    return fmt::format("{} says {} m deep; {}, {} m less.", dispute.oracle, said,
                       LeastTranslation(truth, depth), less);
  }
  if (separation >= 0) {
    return fmt::format(
        "{} says {} m apart; no translation shorter than {} m separates them.",
        dispute.oracle, InMetres(separation), InMetres(-truth.separation.hi));
  }
  const auto [said, depth, more] = TellApart(-separation, -truth.separation.hi, kDigits);
  std::string sentence = fmt::format(
      "{} says {} m deep; no translation shorter than {} m separates them, {} m more",
      dispute.oracle, said, depth, more);
  if (dispute.answer.n_AB_W) {
    const double left =
        OverlapAlong(dispute.query, *dispute.answer.n_AB_W).lo + separation;
    sentence += fmt::format(
        "; moving B by {} m along its own normal {} leaves an overlap of {} m", said,
        FormatVector(*dispute.answer.n_AB_W), InMetres(left));
  }
  return sentence + ".";
}

std::string ProveInconsistency(const Dispute& dispute, const Eigen::Vector3d& n_W,
                               double separation) {
  const double overlap = Middle(OverlapAlong(dispute.query, n_W));
  const auto [said, along, difference] = TellApart(-separation, overlap, kDigits);
  return fmt::format("{} says {} m along {}; the overlap along it is {} m, {} m {}.",
                     dispute.oracle, said, FormatVector(n_W), along, difference,
                     overlap > -separation ? "more" : "less");
}

std::string ProveManifoldInconsistency(const Dispute& dispute, double separation,
                                       const ContactPoint& deepest) {
  const auto [said, found, difference] =
      TellApart(separation, deepest.separation, kDigits);
  return fmt::format(
      "{} says a separation of {} m; that of its deepest contact, at {}, is {} m: a "
      "difference of {} m.",
      dispute.oracle, said, FormatVector(deepest.p_WC), found, difference);
}

std::string ProveExcess(const Dispute& dispute, const Eigen::Vector3d& n_W) {
  const ContactTruth& truth = dispute.truth;
  const double overlap = OverlapAlong(dispute.query, n_W).lo;
  if (truth.separation.lo > 0) {
    const auto [along, gap, more] = TellApart(-overlap, truth.separation.lo, kDigits);
    return fmt::format("{} says n = {}, along which the gap is {} m; {}, {} m more.",
                       dispute.oracle, FormatVector(n_W), along,
                       SeparatingPlane(truth, gap), more);
  }
  const auto [along, depth, less] = TellApart(overlap, -truth.separation.lo, kDigits);
  return fmt::format("{} says n = {}, along which B must move {} m; {}, {} m less.",
                     dispute.oracle, FormatVector(n_W), along,
                     LeastTranslation(truth, depth), less);
}

std::string ProveOppositeNormal(const Dispute& dispute, const Eigen::Vector3d& n_W) {
  return fmt::format(
      "{} says n = {}, which points from B to A: the opposite direction separates them "
      "by {} m, and along n itself they overlap by {} m.",
      dispute.oracle, FormatVector(n_W),
      InMetres(-Middle(OverlapAlong(dispute.query, -n_W))),
      InMetres(Middle(OverlapAlong(dispute.query, n_W))));
}

std::string ProveDualityGap(const Dispute& dispute) {
  const WitnessPoints& w = *dispute.answer.witnesses;
  const Eigen::Vector3d p_AB_W = w.p_WCb - w.p_WCa;
  const auto [said, gap, less] =
      TellApart(p_AB_W.norm(), -Middle(OverlapAlong(dispute.query, p_AB_W)), kDigits);
  return fmt::format(
      "{} says {} of A and {} of B are nearest; they are {} m apart, but the gap along "
      "their direction is {} m, {} m less.",
      dispute.oracle, FormatVector(w.p_WCa), FormatVector(w.p_WCb), said, gap, less);
}

std::string ProveSurfaceError(const Dispute& dispute, const Eigen::Vector3d& p_WCa,
                              const Eigen::Vector3d& p_WCb) {
  return fmt::format(
      "{} puts a contact at {} on A and {} on B; these are {:.9g} m and {:.9g} m from "
      "the surfaces.",
      dispute.oracle, FormatVector(p_WCa), FormatVector(p_WCb),
      std::abs(Middle(SignedDistance(dispute.query.A, p_WCa))),
      std::abs(Middle(SignedDistance(dispute.query.B, p_WCb))));
}

std::string ProveWitnessError(const Dispute& dispute, const Eigen::Vector3d* n_W,
                              double separation) {
  const WitnessPoints& w = *dispute.answer.witnesses;
  const Eigen::Vector3d p_AB_W = w.p_WCb - w.p_WCa;
  const std::string says =
      fmt::format("{} says {} of A and {} of B and a separation of {} m", dispute.oracle,
                  FormatVector(w.p_WCa), FormatVector(w.p_WCb), InMetres(separation));
  if (n_W == nullptr) {
    const auto [length, said, off] =
        TellApart(p_AB_W.norm(), std::abs(separation), kDigits);
    return fmt::format("{}; the points are {} m apart: a difference of {} m.", says,
                       length, off);
  }
  const double along = p_AB_W.dot(*n_W);
  return fmt::format(
      "{} along n = {}; from the first point to the second it is {} m along n and {} m "
      "across.",
      says, FormatVector(*n_W), TellApart(along, separation, kDigits).a,
      InMetres((p_AB_W - along * *n_W).norm()));
}

std::string ProveContactTooShallow(const Dispute& dispute, const WitnessPoints& points,
                                   double more) {
  return fmt::format(
      "{} puts a contact at {} on A and {} on B; there a body extends {} m further along "
      "the normal.",
      dispute.oracle, FormatVector(points.p_WCa), FormatVector(points.p_WCb),
      InMetres(more));
}

std::string ProveSurplusContact(const Dispute& dispute, const WitnessPoints& points,
                                double gap) {
  return fmt::format(
      "{} returns a contact at {} on A and {} on B, which are {} m apart: nothing "
      "touches "
      "there.",
      dispute.oracle, FormatVector(points.p_WCa), FormatVector(points.p_WCb),
      InMetres(gap));
}

std::string ProveOffPatch(const Dispute& dispute, const ContactPoint& contact,
                          double off) {
  return fmt::format(
      "{} puts a contact {:.9g} m deep at {}; the shapes overlap that deep only {:.9g} m "
      "from there, across the normal.",
      dispute.oracle, -contact.separation, FormatVector(contact.p_WC), off);
}

std::string ProveUnspanned(const Dispute& dispute, const Eigen::Vector3d& p_W,
                           double unspanned) {
  return fmt::format(
      "{} returns {}, which leaves {:.0f} % of the patch's extent unspanned; both bodies "
      "reach as deep at {}.",
      dispute.oracle, Counted(dispute.answer.points.size(), "contact"), 100 * unspanned,
      FormatVector(p_W));
}

std::string ProveCount(const Dispute& dispute, const ContactPatch& patch) {
  return fmt::format(
      "{} returns {}; {} would span the patch.", dispute.oracle,
      Counted(dispute.answer.points.size(), "contact"),
      Counted(static_cast<std::uint64_t>(patch.least_contacts), "different one"));
}

std::string ProveTooDeep(const Dispute& dispute, const ContactPoint& contact) {
  const ContactTruth& truth = dispute.truth;
  const auto [said, depth, less] =
      TellApart(-contact.separation, -truth.separation.lo, kDigits);
  const std::string says = fmt::format("{} returns a contact {} m deep at {}",
                                       dispute.oracle, said, FormatVector(contact.p_WC));
  if (truth.separation.lo > 0) {
    return fmt::format("{}; {}.", says,
                       SeparatingPlane(truth, InMetres(truth.separation.lo)));
  }
  return fmt::format("{}; {}, {} m less.", says, LeastTranslation(truth, depth), less);
}

std::string ProveMixedNormals(const Dispute& dispute, double angle) {
  return fmt::format("{} returns normals {:.9g} rad apart in one manifold.",
                     dispute.oracle, angle);
}

}  // namespace touchstone
