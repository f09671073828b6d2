#pragma once

#include <atomic>
#include <memory>
#include <span>

#include <Eigen/Geometry>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** The free fall of all bodies, whatever they meet. */
class Fall final : public Simulation {
 public:
  explicit Fall(const World& world) : world_(world) {}
  void Push(int, const Eigen::Vector3d&, const Eigen::Vector3d&) override {}
  void Step() override { ++step_; }
  void Read(WorldState& state) const override {
    const double t = step_ * world_.dt;
    state.bodies.clear();
    state.particles.clear();
    for (const RigidBody& body : world_.bodies) {
      const Pose& X_WB = body.placed.X_WB;
      const Eigen::Vector3d a_W =
          body.mass > 0 ? world_.gravity_W : Eigen::Vector3d::Zero();
      state.bodies.push_back({X_WB.p_WB + t * body.v_WB + 0.5 * t * t * a_W,
                              Eigen::Quaterniond(X_WB.R_WB), body.v_WB + t * a_W,
                              body.w_WB});
    }
    for (const Particle& particle : world_.particles) {
      const Eigen::Vector3d& a_W = world_.gravity_W;
      state.particles.push_back(
          {particle.p_W + t * particle.v_W + 0.5 * t * t * a_W, particle.v_W + t * a_W});
    }
  }

 private:
  World world_;
  int step_ = 0;
};

/** An engine without contacts, rods and rotation. Before world number `fatal` of its
 life, it does `death`. */
class Faller final : public Oracle {
 public:
  explicit Faller(int fatal = -1, void (*death)() = nullptr)
      : fatal_(fatal), death_(death) {
    info_.name = "faller";
    info_.simulates = true;
    info_.world_capabilities.fill({true, ""});
  }
  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}
  std::unique_ptr<Simulation> Begin(const World& world) const override {
    if (asked_++ == fatal_) death_();
    return std::make_unique<Fall>(world);
  }

 private:
  OracleInfo info_;
  int fatal_;
  void (*death_)();
  mutable std::atomic<int> asked_ = 0;
};

}  // namespace touchstone
