#pragma once

#include <algorithm>

#include <oracles/function_simulator.h>

/** A world engine for Touchstone: balls that bounce on static half-spaces. It has no
 friction, and moving balls pass through each other; MyWorldSimulates() says so. */
class MyWorld final : public touchstone::Simulation {
 public:
  explicit MyWorld(const touchstone::World& world) : world_(world) {
    for (const touchstone::RigidBody& body : world.bodies) {
      const touchstone::Pose& X_WB = body.placed.X_WB;
      state_.bodies.push_back(
          {X_WB.p_WB, Eigen::Quaterniond(X_WB.R_WB), body.v_WB, body.w_WB});
    }
  }

  void Step() override {
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      const touchstone::RigidBody& ball = world_.bodies[i];
      if (ball.mass == 0) continue;  // Static.
      touchstone::BodyState& at = state_.bodies[i];
      // A bounce between two halves of gravity's impulse neither gains nor loses energy.
      at.v_WB += world_.dt / 2 * world_.gravity_W;
      for (const touchstone::RigidBody& ground : world_.bodies)
        Bounce(ball, ground, std::min(ball.restitution, ground.restitution), at);
      at.v_WB += world_.dt / 2 * world_.gravity_W;
      // Without this, the second half would sink a ball at rest a little in every step.
      for (const touchstone::RigidBody& ground : world_.bodies)
        Bounce(ball, ground, 0, at);
      at.p_WB += world_.dt * at.v_WB;
      const double angle = world_.dt * at.w_WB.norm();  // Nothing changes the spin.
      const Eigen::AngleAxisd turn(angle, at.w_WB.stableNormalized());
      if (angle > 0) at.q_WB = (turn * at.q_WB).normalized();
    }
  }

  void Read(touchstone::WorldState& state) const override { state = state_; }

  /** Never called, because MyWorldSimulates() does not name pushes. */
  void Push(int, const Eigen::Vector3d&, const Eigen::Vector3d&) override {}

 private:
  /** Reflects a ball that is in the ground and moves deeper, at `e` of its speed. */
  static void Bounce(const touchstone::RigidBody& ball,
                     const touchstone::RigidBody& ground, double e,
                     touchstone::BodyState& at) {
    if (ground.mass > 0 || !ground.collides || !ball.collides) return;
    const Eigen::Vector3d n_W = ground.placed.X_WB.R_WB.col(2);
    const double gap = n_W.dot(at.p_WB - ground.placed.X_WB.p_WB) -
                       std::get<touchstone::Sphere>(ball.placed.shape).radius;
    const double speed = n_W.dot(at.v_WB);
    if (gap <= 0 && speed < 0) at.v_WB -= (1 + e) * speed * n_W;
  }

  const touchstone::World& world_;
  touchstone::WorldState state_;
};

/** Everything else in a world makes it unsupported, and is no failure. */
inline touchstone::SimulatorPromises MyWorldSimulates() {
  using enum touchstone::WorldFeature;
  return {.simulates = {kSphere, kStaticHalfSpace, kRestitution, kUnequalFriction}};
}
