#include "reports/contacts/checks/touching.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/refutation.h"
#include "reports/contacts/exact_scene.h"
#include "reports/measures/outside.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

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
      PatchAlong(query, proof.n_AB_W, MiddleOf(truth.separation), truth.input_rounding);
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

/** Refutes what the answer says. */
Proof Refuted(const JudgedAnswer& judged) {
  const ContactTruth& truth = judged.truth;
  if (judged.answer.touching) return ByPlane(truth, {.claim = ProofClaim::kTouching});
  Proof proof{.kind = ProofKind::kCommonPoint, .claim = ProofClaim::kApart};
  if (truth.separation.hi >= 0) {
    proof.bound = 0;
    proof.points_W = {truth.certificate.p_WCa};
    return proof;
  }
  const InsidePoint inside = PointInsideBoth(judged.query, truth);
  if (!(inside.depth > 0)) return ByNoTranslation(truth, {.claim = ProofClaim::kApart});
  proof.bound = -inside.depth;
  proof.points_W = {inside.p_W};
  return proof;
}

}  // namespace

std::optional<bool> CertifiedTouching(const ContactTruth& truth) {
  if (truth.separation.lo > 0) return false;
  if (truth.separation.hi <= 0) return true;
  return std::nullopt;
}

double TouchingError(const ContactTruth& truth, const ContactAnswer& answer) {
  if (truth.touching == Touching::kUndecided) return 0;
  return answer.touching == (truth.touching == Touching::kTouching) ? 0 : 1;
}

void CheckTouching(JudgedAnswer& judged) {
  const ContactTruth& truth = judged.truth;
  const double error = TouchingError(truth, judged.answer);
  const double from_touching = Outside(0, truth.separation);
  const double e = judged.tolerances.separation;
  const auto judge = [&judged](double value, const char* reason) {
    judged.Judge(
        {MeasureKind::kTouching, value, 0}, [&] { return std::string(reason); },
        [&] { return Refuted(judged); });
  };
  if (truth.touching != Touching::kUndecided && (error == 0 || from_touching > e))
    return judge(error, "the truth is certified");
  if (IsExactScene(judged.query, judged.oracle.unit_roundoff)) {
    if (const auto exact = TouchingInExactScene(judged.query, truth))
      return judge(
          judged.answer.touching == *exact ? 0 : 1,
          "the truth is certified, and the numbers of the scene need no rounding");
  }
  const std::optional<bool> sign = CertifiedTouching(truth);
  const Undecided undecided = !sign                             ? Undecided::kUnknown
                              : *sign == judged.answer.touching ? Undecided::kAgreed
                                                                : Undecided::kOpposed;
  judged.LeaveUndecided(MeasureKind::kTouching, error, 0, undecided, [&] {
    return truth.touching == Touching::kUndecided
               ? fmt::format("touching to within {:.2g} m, the rounding of the input{}",
                             truth.input_rounding,
                             sign ? "" : ", or undecided by " + truth.method)
               : fmt::format("{:.2g} m from touching, within {:.2g} m: {}", from_touching,
                             e, judged.because.Separation());
  });
}

}  // namespace touchstone
