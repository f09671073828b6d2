// The command line with four oracles of known behaviour, so that its output and exit
// code do not depend on the installed engines.
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "cli/command_line.h"
#include "oracles/function_oracle.h"
#include "oracles/simulation.h"

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

// The free fall of the bodies and particles of a world, with `drift` [m/s] along x added.
class DriftingFall final : public Simulation {
 public:
  DriftingFall(const World& world, double drift) : world_(world), drift_W_(drift, 0, 0) {}
  void Push(int, const Eigen::Vector3d&, const Eigen::Vector3d&) override {}
  void Step() override { ++step_; }
  void Read(WorldState& state) const override {
    const double t = step_ * world_.dt;
    const Eigen::Vector3d& g_W = world_.gravity_W;
    state.bodies.clear();
    for (const RigidBody& body : world_.bodies) {
      const Pose& X_WB = body.placed.X_WB;
      state.bodies.push_back({X_WB.p_WB + t * (body.v_WB + drift_W_) + 0.5 * t * t * g_W,
                              Eigen::Quaterniond(X_WB.R_WB), body.v_WB + t * g_W,
                              body.w_WB});
    }
    state.particles.clear();
    for (const Particle& particle : world_.particles) {
      state.particles.push_back(
          {particle.p_W + t * (particle.v_W + drift_W_) + 0.5 * t * t * g_W,
           particle.v_W + t * g_W});
    }
  }

 private:
  World world_;
  Eigen::Vector3d drift_W_;
  int step_ = 0;
};

// Right as it ships: only its adapter makes it drift.
class Drifter final : public Oracle {
 public:
  Drifter() {
    info_.name = "drifter";
    info_.library = "Drifter";
    info_.version = "1.0";
    info_.simulates = true;
    info_.world_capabilities.fill({true, ""});
    info_.parameters = {{.name = "drift",
                         .here = 0.5,
                         .shipped = 0,
                         .least = 0,
                         .most = 9,
                         .whole = false,
                         .what = "drift along x in m/s",
                         .why = "To have a fault."}};
  }
  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}
  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return std::make_unique<DriftingFall>(world, values.front());
  }

 private:
  OracleInfo info_;
};

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
  registry.Add(std::make_unique<Drifter>());
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
