#include "tests/reports/worlds/study/studied.h"

#include <cmath>

#include "tests/reports/worlds/motions.h"

namespace touchstone {

WorldScenario TwoBallsInFlight() {
  WorldScenario scenario;
  scenario.id = "world/test/flight";
  RigidBody near = BodyOf("near", Sphere{0.5}, 2, {0.3, 1.7, -0.4});
  near.v_WB = {1.3, 4.1, -0.7};
  near.w_WB = {0.4, -1.2, 2.3};
  RigidBody far = BodyOf("far", Sphere{0.2}, 0.7, {4.3, 0.7, 2.1});
  far.v_WB = {-0.3, 2.2, 1.1};
  scenario.world.bodies = {near, far};
  scenario.world.dt = 0.01;
  scenario.world.steps = 100;
  scenario.claims = {ClaimOf("ballistic")};
  return scenario;
}

Studied::Studied(const WorldScenario& s, const FakeSimulator& oracle)
    : scenario(s),
      info(oracle.info()),
      whole(oracle.Simulate(s.world)),
      half(oracle.Simulate(Refined(s.world, 2))),
      quarter(oracle.Simulate(Refined(s.world, 4))) {}

FakeSimulator OffBy(double scale, double order) {
  return FakeSimulator("off", [=](const World& world) {
    return FreeFlight(world, [&](double t) {
      return Eigen::Vector3d(scale * std::pow(world.dt, order) * t *
                             Eigen::Vector3d(1, 2, -1));
    });
  });
}

}  // namespace touchstone
