#pragma once

#include <memory>
#include <string>

#include "oracles/function_oracle.h"

namespace touchstone {

/** Two spheres by the closed form. The depth is stated multiplied by `share`. */
inline std::unique_ptr<Oracle> Spheres(const std::string& name, double share) {
  return MakeOracle<Sphere, Sphere>(name, [share](const Sphere& A, const Pose& X_WA,
                                                  const Sphere& B, const Pose& X_WB) {
    const Eigen::Vector3d p_AB = X_WB.p_WB - X_WA.p_WB;
    const double separation = p_AB.norm() - A.radius - B.radius;
    ContactAnswer answer;
    answer.status = AnswerStatus::kAnswered;
    answer.touching = separation <= 0;
    if (!answer.touching) return answer;
    answer.separation = share * separation;
    answer.n_AB_W = p_AB.normalized();
    return answer;
  });
}

}  // namespace touchstone
