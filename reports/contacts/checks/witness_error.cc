#include "reports/contacts/checks/witness_error.h"

#include <cmath>

#include <fmt/format.h>

#include "reports/contacts/checks/judged_answer.h"

namespace touchstone {

WitnessError WitnessErrorOf(const WitnessPoints& witnesses, const Eigen::Vector3d& n_AB_W,
                            double separation) {
  const Eigen::Vector3d p_AB_W = witnesses.p_WCb - witnesses.p_WCa;
  const double along = p_AB_W.dot(n_AB_W);
  return {std::abs(along - separation), (p_AB_W - along * n_AB_W).norm()};
}

double WitnessLengthError(const WitnessPoints& witnesses, double separation) {
  return std::abs((witnesses.p_WCb - witnesses.p_WCa).norm() - std::abs(separation));
}

void CheckWitnesses(JudgedAnswer& judged) {
  if (!judged.answer.witnesses || !judged.separation) return;
  const WitnessPoints& w = *judged.answer.witnesses;
  const double separation = *judged.separation;
  const bool has_direction = judged.ClaimsLeastDirection();
  const WitnessError error = has_direction
                                 ? WitnessErrorOf(w, *judged.n_W, separation)
                                 : WitnessError{WitnessLengthError(w, separation), 0};
  const double each = judged.tolerances.position;
  const double along = 3 * each;
  // Both points and the direction between them are rounded, however small the bodies.
  const double across = judged.tolerances.across + along;
  const bool by_across = error.across * along > error.along * across;
  const auto because = [&] {
    return fmt::format("two points and a separation, each off by {:.2g} m: {}{}", each,
                       judged.because.Position(),
                       by_across ? "; " + judged.because.Across() : "");
  };
  const auto prove = [&] {
    const Eigen::Vector3d p_AB_W = w.p_WCb - w.p_WCa;
    Proof proof{.kind = ProofKind::kWitnesses,
                .said = separation,
                .bound = p_AB_W.norm(),
                .points_W = {w.p_WCa, w.p_WCb}};
    if (!has_direction) return proof;
    proof.claimed_W = *judged.n_W;
    proof.bound = p_AB_W.dot(proof.claimed_W);
    proof.rest = (p_AB_W - proof.bound * proof.claimed_W).norm();
    return proof;
  };
  judged.Judge({MeasureKind::kWitnessError, by_across ? error.across : error.along,
                by_across ? across : along},
               because, prove);
}

}  // namespace touchstone
