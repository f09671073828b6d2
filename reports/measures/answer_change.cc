#include "reports/measures/answer_change.h"

#include <cmath>
#include <utility>

#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"
#include "reports/measures/stated.h"

namespace touchstone {
namespace {

template <typename MapNormal, typename MapPoint>
void Map(ContactAnswer& answer, double lengths, MapNormal normal, MapPoint point) {
  if (answer.separation) *answer.separation *= lengths;
  if (answer.n_AB_W) answer.n_AB_W = normal(*answer.n_AB_W);
  for (ContactPoint& contact : answer.points) {
    contact.p_WC = point(contact.p_WC);
    contact.separation *= lengths;
    if (contact.n_AB_W) contact.n_AB_W = normal(*contact.n_AB_W);
  }
  if (answer.witnesses) {
    answer.witnesses->p_WCa = point(answer.witnesses->p_WCa);
    answer.witnesses->p_WCb = point(answer.witnesses->p_WCb);
  }
}

}  // namespace

AnswerDifference AnswerChange(const ContactQuery& query, const ContactTruth& truth,
                              const ContactAnswer& answer,
                              const ContactAnswer& brought_back) {
  AnswerDifference change;
  if (answer.touching != brought_back.touching) {
    change.separation = Outside(0, truth.separation);
  }
  const auto separation = SeparationOf(answer);
  const auto separation_back = SeparationOf(brought_back);
  if (separation && separation_back) {
    change.separation =
        std::max(change.separation, std::abs(*separation - *separation_back));
    change.compared = true;
  }
  const auto n_W = NormalOf(answer);
  const auto n_W_back = NormalOf(brought_back);
  if (n_W && n_W_back) {
    // Most variants leave a normal as it was, to the bit.
    if (*n_W != *n_W_back)
      change.overlap = Apart(OverlapAlong(query, *n_W), OverlapAlong(query, *n_W_back));
    change.compared = true;
  }
  return change;
}

ContactAnswer BackFromSwap(ContactAnswer answer) {
  Map(
      answer, 1, [](const Eigen::Vector3d& n) { return Eigen::Vector3d(-n); },
      [](const Eigen::Vector3d& p) { return p; });
  if (answer.witnesses) std::swap(answer.witnesses->p_WCa, answer.witnesses->p_WCb);
  return answer;
}

ContactAnswer BackFromMotion(ContactAnswer answer, const Eigen::Isometry3d& X_VW) {
  const Eigen::Isometry3d X_WV = X_VW.inverse();
  Map(
      answer, 1,
      [&](const Eigen::Vector3d& n) { return Eigen::Vector3d(X_WV.linear() * n); },
      [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(X_WV * p); });
  return answer;
}

ContactAnswer BackFromScale(ContactAnswer answer, double factor) {
  Map(
      answer, 1 / factor, [](const Eigen::Vector3d& n) { return n; },
      [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(p / factor); });
  return answer;
}

}  // namespace touchstone
