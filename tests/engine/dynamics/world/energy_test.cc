#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/dynamics/world/world.h"
#include "tests/engine/dynamics/random.h"

namespace cookbook {
namespace {

constexpr int kSteps = 60;
/** Energy that rounding and the residual of the solver may add in a step, as a fraction
 of the energy at the start. */
constexpr double kRounding = 1e-11;
/** The same in single precision: ten iterations of about 30 operations. */
constexpr double kSingleRounding = 10 * 30 * 6e-8;

enum class Form { kBar, kPlate, kBrick, kCube };

Box RandomBox(Form form, Random& random) {
  const double size = random.LogUniform(0.1, 1);
  const double thin = random.LogUniform(0.01, 0.5);
  switch (form) {
    case Form::kBar:
      return {size * Eigen::Vector3d(1, thin, thin)};
    case Form::kPlate:
      return {size * Eigen::Vector3d(1, 1, thin)};
    case Form::kBrick:
      return {size *
              Eigen::Vector3d(1, random.LogUniform(0.05, 1), random.LogUniform(0.05, 1))};
    case Form::kCube:
      break;
  }
  return {size * Eigen::Vector3d::Ones()};
}

/** Bodies that fly at each other without gravity. */
struct Collision {
  std::vector<BodyDefinition> bodies;
  double h;

  double EnergyOf(const World& world) const {
    double energy = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const BodyDefinition& body = bodies[k];
      const int i = static_cast<int>(k);
      if (body.mass == 0) continue;
      const BodyState& state = world.state(i);
      const Eigen::Vector3d w_B = state.q_WB.conjugate() * state.w_WB;
      const Eigen::Vector3d moments = PrincipalInertia(body.shape, body.mass);
      energy += body.mass * state.v_WB.squaredNorm() / 2 +
                w_B.dot(moments.cwiseProduct(w_B)) / 2;
    }
    return energy;
  }
};

/** Forms to 1 : 100, spins to 4 rad a step, e and μ in [0, 1], steps of 1/30 to 1/1000 s,
 a wall or a free body. */
Collision RandomCollision(std::uint64_t seed) {
  Random random(seed);
  const auto one_in = [&](int n) { return random.Uniform(0, n) < 1; };
  Collision collision;
  collision.h = random.LogUniform(1e-3, 1.0 / 30);
  const double ends = random.Uniform(-0.3, 1.3);  // Often exactly 0 or 1.
  const double restitution = std::clamp(ends, 0.0, 1.0);
  const double friction = one_in(2) ? 0 : random.Uniform(0, 1);
  collision.bodies.resize(2);
  BodyDefinition& body = collision.bodies[0];
  BodyDefinition& target = collision.bodies[1];
  const Box box = RandomBox(static_cast<Form>(random.Uniform(0, 4)), random);
  const double radius = box.half_extents.norm();
  body.shape = box;
  body.mass = random.LogUniform(0.1, 10);
  body.state.q_WB = random.Rotation();
  body.state.v_WB = {random.Uniform(0.5, 10), random.Uniform(-1, 1),
                     random.Uniform(-1, 1)};
  const double spin =
      one_in(2) ? random.Uniform(0, 10) : random.Uniform(0, 4) / collision.h;
  body.state.w_WB = spin * random.Direction();
  if (one_in(2)) {
    target.shape = Box{{0.5, 40, 40}};
    target.mass = 0;
    target.state.p_WB.x() = radius + 0.5 + random.Uniform(0.01, 0.6);
  } else {
    const Box other = RandomBox(one_in(2) ? Form::kBrick : Form::kCube, random);
    target.shape = other;
    target.mass = random.LogUniform(0.1, 10);
    target.state.p_WB = {radius + other.half_extents.norm() + random.Uniform(0.01, 0.3),
                         radius * random.Uniform(-0.3, 0.3),
                         radius * random.Uniform(-0.3, 0.3)};
    target.state.q_WB = random.Rotation();
    target.state.w_WB = random.Uniform(0, 10) * random.Direction();
  }
  for (BodyDefinition& one : collision.bodies) {
    one.restitution = restitution;
    one.friction = friction;
  }
  return collision;
}

/** A box that tumbles at a wall, or is in it a little, and a heavy body that hits it
 there. Aspects to 1 : 30, spins to 4 rad a step, mass ratios of 3 to 100. */
Collision RandomHit(std::uint64_t seed) {
  Random random(seed);
  const auto one_in = [&](int n) { return random.Uniform(0, n) < 1; };
  Collision collision;
  collision.h = random.LogUniform(1.0 / 240, 1.0 / 30);
  collision.bodies.resize(3);
  BodyDefinition& wall = collision.bodies[0];
  wall.shape = Box{{3, 0.5, 3}};
  wall.state.p_WB.y() = -0.5;
  wall.mass = 0;
  BodyDefinition& box_at_wall = collision.bodies[1];
  const Box box{{random.Uniform(0.2, 0.6), random.LogUniform(0.02, 0.3),
                 random.LogUniform(0.02, 0.3)}};
  box_at_wall.shape = box;
  box_at_wall.state.q_WB = random.Rotation();
  const double height =
      (box_at_wall.state.q_WB.toRotationMatrix().row(1).transpose().cwiseProduct(
           box.half_extents))
          .lpNorm<1>();
  box_at_wall.state.p_WB.y() = height + random.Uniform(-0.05, 0.1);
  box_at_wall.state.v_WB = random.Uniform(0, 5) * random.Direction();
  const double spin =
      one_in(2) ? random.Uniform(0, 30) : random.Uniform(0, 4) / collision.h;
  box_at_wall.state.w_WB = spin * random.Direction();
  BodyDefinition& other = collision.bodies[2];
  if (one_in(2))
    other.shape = Sphere{random.Uniform(0.1, 0.4)};
  else
    other.shape = Box{{0.2, 0.25, 0.2}};
  other.mass = random.LogUniform(3, 100);
  other.state.p_WB = {random.Uniform(-0.2, 0.2),
                      box_at_wall.state.p_WB.y() + height + random.Uniform(0.4, 1),
                      random.Uniform(-0.2, 0.2)};
  other.state.v_WB.y() = -random.Uniform(1, 20);
  const double restitution = std::clamp(random.Uniform(-0.3, 1.3), 0.0, 1.0);
  const double friction = one_in(2) ? 0 : random.Uniform(0, 1);
  for (BodyDefinition& one : collision.bodies) {
    one.restitution = restitution;
    one.friction = friction;
  }
  return collision;
}

/** Returns the greatest energy that a step adds, as a fraction of that at the start. */
double GreatestGain(const Collision& collision, bool continuous, bool single = false) {
  Settings settings;
  settings.gravity_W.setZero();
  settings.continuous_collision = continuous;
  if (single) settings.iteration_budget = 0;
  World world(settings);
  for (const BodyDefinition& body : collision.bodies) world.AddBody(body);
  const double start = collision.EnergyOf(world);
  double before = start;
  double gain = 0;
  for (int k = 0; k < kSteps; ++k) {
    world.Step(collision.h);
    const double after = collision.EnergyOf(world);
    gain = std::max(gain, (after - before) / start);
    before = after;
  }
  return gain;
}

class EnergyOfCollisions : public testing::TestWithParam<bool> {};

TEST_P(EnergyOfCollisions, NeverRises) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed)
    EXPECT_LE(GreatestGain(RandomCollision(seed), GetParam()), kRounding) << seed;
}

TEST_P(EnergyOfCollisions, NeverRisesInSinglePrecision) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    EXPECT_LE(GreatestGain(RandomCollision(seed), GetParam(), true), kSingleRounding)
        << seed;
  }
}

// The body has contacts at the wall, so it is no body in free flight. Its contacts
// may have no impulse, or hold it in a wedge with friction between the wall and the
// other.
TEST_P(EnergyOfCollisions, NeverRisesAtAWall) {
  for (std::uint64_t seed = 0; seed < 500; ++seed)
    EXPECT_LE(GreatestGain(RandomHit(seed), GetParam()), kRounding) << seed;
}

INSTANTIATE_TEST_SUITE_P(, EnergyOfCollisions, testing::Bool(), [](const auto& test) {
  return test.param ? "Continuous" : "Discrete";
});

// A thin bar spins about its length, and one end is inside a wall. Position correction
// turns the bar; the momentum about its length, of a moment 200 times smaller than the
// others, may turn with it and no further.
TEST(PositionCorrection, TurnsTheMomentumOfABarNoFurtherThanTheBar) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition wall;
  wall.shape = Box{{5, 0.5, 5}};
  wall.mass = 0;
  wall.restitution = 0;
  wall.state.p_WB.y() = -0.5;
  world.AddBody(wall);
  BodyDefinition bar;
  const Box box{{0.4, 0.02, 0.02}};
  bar.shape = box;
  bar.mass = 1;
  bar.restitution = 0;
  bar.state.q_WB = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ());
  // The middle of its lower end is on the wall. Nothing approaches: there are no
  // impulses.
  bar.state.p_WB.y() = 0.4 * std::sin(0.2);
  bar.state.v_WB.y() = 1.1;
  bar.state.w_WB = bar.state.q_WB * Eigen::Vector3d(50, 0, 0);
  const int index = world.AddBody(bar);
  const Eigen::Vector3d moments = PrincipalInertia(box, bar.mass);
  const auto momentum = [&](const BodyState& state) {
    const Eigen::Vector3d w_B = state.q_WB.conjugate() * state.w_WB;
    return Eigen::Vector3d(state.q_WB * moments.cwiseProduct(w_B));
  };
  const auto along = [](const BodyState& state) {
    return Eigen::Vector3d(state.q_WB * Eigen::Vector3d::UnitX());
  };
  const Eigen::Vector3d L_start = momentum(bar.state);
  world.Step(1.0 / 2400);
  const BodyState& state = world.state(index);
  const double turned = (along(state) - along(bar.state)).norm();
  EXPECT_GT(turned, 1e-3);
  EXPECT_LE((momentum(state) - L_start).norm(), 1.001 * turned * L_start.norm());
}

// For 10⁵ cases: RC_PARAMS=max_success=100000.
RC_GTEST_PROP(EnergyOfRandomCollisions, NeverRises, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto continuous = *rc::gen::arbitrary<bool>();
  RC_ASSERT(GreatestGain(RandomCollision(seed), continuous) <= kRounding);
}

RC_GTEST_PROP(EnergyOfRandomCollisionsAtAWall, NeverRises, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  RC_ASSERT(GreatestGain(RandomHit(seed), true) <= kRounding);
}

}  // namespace
}  // namespace cookbook
