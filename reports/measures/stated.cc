#include "reports/measures/stated.h"

#include <algorithm>

namespace touchstone {

const ContactPoint* DeepestOf(const ContactAnswer& answer) {
  const auto deepest = std::min_element(answer.points.begin(), answer.points.end(),
                                        [](const ContactPoint& a, const ContactPoint& b) {
                                          return a.separation < b.separation;
                                        });
  return deepest == answer.points.end() ? nullptr : &*deepest;
}

std::optional<Eigen::Vector3d> NormalOf(const ContactAnswer& answer) {
  if (answer.n_AB_W) return answer.n_AB_W->normalized();
  const ContactPoint* deepest = DeepestOf(answer);
  if (deepest != nullptr && deepest->n_AB_W) return deepest->n_AB_W->normalized();
  return std::nullopt;
}

std::optional<double> SeparationOf(const ContactAnswer& answer) {
  if (answer.separation) return answer.separation;
  const ContactPoint* deepest = DeepestOf(answer);
  return deepest != nullptr ? std::optional(deepest->separation) : std::nullopt;
}

}  // namespace touchstone
