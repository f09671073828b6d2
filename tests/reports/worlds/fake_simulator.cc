#include "tests/reports/worlds/fake_simulator.h"

#include <utility>

#include "tests/reports/worlds/motions.h"

namespace touchstone {

FakeSimulator::FakeSimulator(std::string name, Function function)
    : function_(std::move(function)) {
  info_.name = std::move(name);
  info_.library = "fake";
  info_.simulates = true;
  info_.world_capabilities.fill({true, ""});
}

void FakeSimulator::Answer(std::span<const ContactQuery>,
                           std::span<ContactAnswer> answers) const {
  for (ContactAnswer& answer : answers) answer.status = AnswerStatus::kUnsupported;
}

Trajectory FreeFlight(const World& world,
                      const std::function<Eigen::Vector3d(double)>& off) {
  const auto fall = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& v, double t) {
    const Eigen::Vector3d error = off ? off(t) : Eigen::Vector3d::Zero();
    return Eigen::Vector3d(p + t * v + 0.5 * t * t * world.gravity_W + error);
  };
  return Sampled(world, [&](double t) {
    WorldState state;
    for (const RigidBody& body : world.bodies) {
      const Eigen::Quaterniond q_WB(body.placed.X_WB.R_WB);
      if (body.mass == 0) {
        state.bodies.push_back({body.placed.X_WB.p_WB, q_WB, Eigen::Vector3d::Zero(),
                                Eigen::Vector3d::Zero()});
        continue;
      }
      state.bodies.push_back({fall(body.placed.X_WB.p_WB, body.v_WB, t),
                              Turned(q_WB, t * body.w_WB),
                              body.v_WB + t * world.gravity_W, body.w_WB});
    }
    for (const Particle& particle : world.particles) {
      state.particles.push_back(
          {fall(particle.p_W, particle.v_W, t), particle.v_W + t * world.gravity_W});
    }
    return state;
  });
}

}  // namespace touchstone
