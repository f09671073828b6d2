#include "reports/contacts/checks/excess.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/refutation.h"
#include "reports/measures/overlap_along.h"

namespace touchstone {
namespace {

/** Judges whether the normal separates the bodies. */
void CheckThatItSeparates(JudgedAnswer& judged) {
  const Eigen::Vector3d& n_W = *judged.n_W;
  const double overlap = std::max(0.0, judged.Along().lo);
  const double tolerance = judged.tolerances.apart;
  const Enclosure against = OverlapAlong(judged.query, -n_W);
  if (!(overlap <= tolerance) && std::isfinite(tolerance) && !(against.hi < 0)) {
    judged.LeaveUndecided(MeasureKind::kExcess, overlap, tolerance,
                          Undecided::kUnverified, [] {
                            return std::string(
                                "its normal separates nothing, and without a distance it "
                                "claims nothing else");
                          });
    return;
  }
  judged.Judge(
      {MeasureKind::kExcess, overlap, tolerance}, [&] { return judged.because.Apart(); },
      [&]() -> Proof {
        return {.kind = ProofKind::kOpposite,
                .said = -MiddleOf(against),
                .bound = -MiddleOf(judged.Along()),
                .claimed_W = n_W};
      });
}

}  // namespace

double Excess(const ContactQuery& query, const ContactTruth& truth,
              const Eigen::Vector3d& n_W) {
  return Excess(OverlapAlong(query, n_W), truth);
}

double Excess(const Enclosure& overlap, const ContactTruth& truth) {
  // −separation.lo is the largest possible depth: only an overlap beyond it is proved
  // excess.
  return std::max(0.0, overlap.lo + truth.separation.lo);
}

void CheckNormal(JudgedAnswer& judged) {
  if (!judged.n_W) return;
  if (!judged.ClaimsLeastDirection()) {
    // A separation that is stated without a promise is judged along the normal.
    if (!judged.separation) CheckThatItSeparates(judged);
    return;
  }
  const Enclosure& along = judged.Along();
  const auto prove = [&] {
    return ByPlaneOrTranslation(
        judged.truth,
        {.claim = ProofClaim::kNormal, .said = -along.lo, .claimed_W = *judged.n_W});
  };
  const Verdict verdict = judged.Judge(
      {.measure = MeasureKind::kExcess,
       .value = Excess(along, judged.truth),
       .tolerance = judged.tolerances.excess,
       .worst = along.hi + judged.truth.separation.hi},
      [&] { return judged.because.Excess(); }, prove);
  judged.normal_is_right = verdict == Verdict::kPass;
}

}  // namespace touchstone
