#include "tests/reports/worlds/study/tie.h"

#include "tests/reports/worlds/motions.h"

namespace touchstone {

WorldScenario Tie() {
  WorldScenario scenario;
  scenario.id = "world/test/tie";
  World& world = scenario.world;
  const Eigen::Vector3d start(0.3, 1.7, -0.4);
  const Eigen::Vector3d along = Eigen::Vector3d(2, 1, 2) / 3;
  world.bodies = {BodyOf("post", Sphere{0.1}, 0, start + 2.5 * along),
                  BodyOf("ball", Sphere{0.1}, 1, start)};
  for (RigidBody& body : world.bodies) body.collides = false;
  world.bodies[1].v_WB = 3 * along;
  world.gravity_W.setZero();
  world.dt = 1.0 / 128;
  world.steps = 128;
  scenario.claims = {ClaimOf("deterministic")};
  return scenario;
}

std::size_t BallOf(const World& world) {
  return world.bodies[0].mass > 0 ? 0 : 1;
}

Trajectory TurnsBackNear(const World& world) {
  return Stepped(world, [&](WorldState& state) {
    BodyState& ball = state.bodies[BallOf(world)];
    ball.p_WB += world.dt * ball.v_WB;
    const Eigen::Vector3d ahead = state.bodies[1 - BallOf(world)].p_WB - ball.p_WB;
    if (ahead.norm() <= 1 && ahead.dot(ball.v_WB) > 0) ball.v_WB = -ball.v_WB;
  });
}

}  // namespace touchstone
