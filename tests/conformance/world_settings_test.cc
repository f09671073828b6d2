// Every parameter that an adapter offers for worlds changes how something moves.

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

const OracleRegistry& Registry() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

RigidBody BodyAt(std::string name, const Shape& shape, const Vector3d& p_W, double mass) {
  RigidBody body;
  body.name = std::move(name);
  body.placed = {shape, Pose::FromQuaternion(p_W, {1, 0, 0, 0})};
  body.mass = mass;
  return body;
}

World OnAFloor() {
  World world;
  world.gravity_W = {0, 0, -9.81};
  world.dt = 0.01;
  world.steps = 400;
  world.sample_every = 20;
  world.bodies = {BodyAt("floor", Box{{50, 50, 1}}, {0, 0, -1}, 0)};
  return world;
}

/** A plank that lands askew, slides, turns and comes to rest; a ball that rolls. */
World Landing() {
  World world = OnAFloor();
  RigidBody plank = BodyAt("plank", Box{{0.4, 0.2, 0.1}}, {0, 0, 0.5}, 1);
  plank.placed.X_WB = Pose::FromQuaternion(
      {0, 0, 0.5}, Eigen::Quaterniond(0.9, 0.2, 0.1, 0.3).normalized());
  plank.v_WB = {1, 0.5, 0};
  plank.w_WB = {3, 2, 5};
  world.bodies.push_back(plank);
  RigidBody ball = BodyAt("ball", Sphere{0.2}, {3, 0, 0.2}, 1);
  ball.v_WB = {0.5, 0, 0};
  ball.w_WB = {0, 0, 2};
  world.bodies.push_back(ball);
  return world;
}

/** The same without restitution, which not every engine has. */
World LandingDead() {
  World world = Landing();
  for (RigidBody& body : world.bodies) body.restitution = 0;
  return world;
}

/** A box that starts 5 cm inside the floor. */
World Sunk() {
  World world = OnAFloor();
  for (RigidBody& body : world.bodies) body.restitution = 0;
  RigidBody box = BodyAt("box", Box{{0.4, 0.2, 0.2}}, {0, 0, 0.15}, 1);
  box.restitution = 0;
  world.bodies.push_back(box);
  return world;
}

/** A ball that is beyond a thin wall after a step. */
World Fast() {
  World world = OnAFloor();
  world.bodies.push_back(BodyAt("wall", Box{{0.01, 5, 5}}, {2, 0, 5}, 0));
  RigidBody ball = BodyAt("ball", Sphere{0.1}, {0, 0, 3}, 1);
  ball.v_WB = {90, 0, 0};
  world.bodies.push_back(ball);
  return world;
}

/** A hull that is set on the floor. */
World Hull() {
  World world = OnAFloor();
  for (RigidBody& body : world.bodies) body.restitution = 0;
  const ConvexHull shape{
      {{0.3, 0, 0}, {-0.3, 0, 0}, {0, 0.3, 0}, {0, -0.3, 0}, {0, 0, 0.3}, {0, 0, -0.3}}};
  RigidBody hull = BodyAt("hull", shape, {0, 0, 0.4}, 1);
  hull.restitution = 0;
  world.bodies.push_back(hull);
  return world;
}

/** A ball on a rod that is too short. */
World Stretched() {
  World world;
  world.dt = 0.01;
  world.steps = 100;
  world.sample_every = 10;
  world.bodies = {BodyAt("ball", Sphere{0.1}, {1, 0, 0}, 1)};
  world.joints = {{{AnchorKind::kWorld, -1, Vector3d::Zero()},
                   {AnchorKind::kBody, 0, Vector3d::Zero()},
                   0.9}};
  return world;
}

std::vector<Vector3d> PlacesIn(const World& world, const Oracle& oracle) {
  std::vector<Vector3d> places;
  if (!oracle.CannotSimulate(world).empty()) return places;
  for (const WorldState& state : oracle.Simulate(world).samples)
    for (const BodyState& body : state.bodies) places.push_back(body.p_WB);
  return places;
}

/** Returns whether some value of the parameter moves something elsewhere than the value
 in force in `setup`. */
bool Moves(const Oracle& oracle, const WorldParameter& parameter, const WorldSetup& setup,
           const World& world) {
  const std::unique_ptr<Oracle> before = oracle.SetUp(setup);
  const std::vector<Vector3d> places = PlacesIn(world, *before);
  if (places.empty()) return false;
  for (const double value : {parameter.shipped, parameter.here, parameter.least, 0.05,
                             1.0, 2.0, 20.0, parameter.most}) {
    if (!Refusal(parameter, value).empty()) continue;
    WorldSetup chosen = setup;
    chosen.chosen[parameter.name] = value;
    const std::unique_ptr<Oracle> after = oracle.SetUp(chosen);
    if (PlacesIn(world, *after) != places) return true;
  }
  return false;
}

class WorldSettings : public testing::TestWithParam<std::string> {};

TEST_P(WorldSettings, EachChangesAMotion) {
  const Oracle& oracle = *Registry().Find(GetParam());
  // Some matter only beside others: overlap is not corrected as set here, nothing is
  // swept or sleeps, Bullet brakes spin only where it brakes rolling, and the cookbook
  // engine takes floats only where it has no iterations left.
  std::vector<WorldSetup> setups = {{}, {.as_shipped = true, .chosen = {}}};
  for (const auto& [name, value] :
       {std::pair("ccd_threshold", 0.1), std::pair("rolling_friction", 0.1),
        std::pair("sleep_after", 0.2), std::pair("iteration_budget", 0.0)}) {
    setups.push_back({.as_shipped = false, .chosen = {{name, value}}});
  }
  const std::vector<World> worlds = {Landing(), LandingDead(), Sunk(),
                                     Fast(),    Hull(),        Stretched()};
  for (const WorldParameter& parameter : oracle.info().parameters) {
    const bool moves = std::ranges::any_of(setups, [&](const WorldSetup& setup) {
      const bool exists = std::ranges::all_of(setup.chosen, [&](const auto& chosen) {
        return std::ranges::any_of(
            oracle.info().parameters,
            [&](const WorldParameter& other) { return other.name == chosen.first; });
      });
      return exists && std::ranges::any_of(worlds, [&](const World& world) {
               return Moves(oracle, parameter, setup, world);
             });
    });
    // A step has the same bits for any number of threads.
    EXPECT_EQ(moves, parameter.name != "threads") << parameter.name;
  }
}

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const Oracle* oracle : Registry().All()) {
    if (oracle->info().HasSetups()) names.push_back(oracle->info().name);
  }
  return names;
}

std::string TestName(const testing::TestParamInfo<std::string>& name) {
  std::string text = name.param;
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return text;
}

INSTANTIATE_TEST_SUITE_P(Oracles, WorldSettings, testing::ValuesIn(Names()), TestName);

}  // namespace
}  // namespace touchstone
