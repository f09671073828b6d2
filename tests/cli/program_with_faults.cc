// The command line with three oracles of known behaviour, so that its output and exit
// code do not depend on the installed engines.
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "cli/command_line.h"
#include "oracles/function_oracle.h"

namespace touchstone {
namespace {

// Closed form: the separation is the distance of the centres minus the radii. The answer
// states it multiplied by `share`.
ContactAnswer Spheres(const Sphere& A, const Pose& X_WA, const Sphere& B,
                      const Pose& X_WB, double share) {
  const Eigen::Vector3d p_AB = X_WB.p_WB - X_WA.p_WB;
  const double separation = p_AB.norm() - A.radius - B.radius;
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = separation <= 0;
  if (answer.touching) {
    answer.separation = share * separation;
    answer.n_AB_W = p_AB.normalized();
  }
  return answer;
}

OracleRegistry Registry() {
  OracleRegistry registry;
  registry.Add(MakeOracle<Sphere, Sphere>(
      "right", [](const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
        return Spheres(A, X_WA, B, X_WB, 1);
      }));
  registry.Add(MakeOracle<Sphere, Sphere>(
      "half_depth", [](const Sphere& A, const Pose& X_WA, const Sphere& B,
                       const Pose& X_WB) { return Spheres(A, X_WA, B, X_WB, 0.5); }));
  registry.Add(MakeOracle<Sphere, Sphere>(
      "thrower",
      [](const Sphere&, const Pose&, const Sphere&, const Pose&) -> ContactAnswer {
        throw std::runtime_error("out of spheres");
      }));
  return registry;
}

}  // namespace
}  // namespace touchstone

int main(int argc, char** argv) {
  touchstone::CommandLineDefaults defaults;
  defaults.subject = "right";
  if (const char* data = std::getenv("TOUCHSTONE_TEST_DATA")) defaults.data = data;
  return touchstone::RunCommandLine(argc, argv, touchstone::Registry(), defaults);
}
