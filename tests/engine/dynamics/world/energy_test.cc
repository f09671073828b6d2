#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr int kSteps = 60;
/** Energy that rounding and the residual of the solver may add in a step, as a fraction
 of the energy at the start. */
constexpr double kRounding = 1e-11;
/** The same in single precision: seven iterations of about 30 operations. */
constexpr double kSingleRounding = 7 * 30 * 6e-8;

/** Random numbers with the same values on every platform. */
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  double Uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  double LogUniform(double low, double high) {
    return std::exp(Uniform(std::log(low), std::log(high)));
  }
  Eigen::Vector3d Direction() {
    const double z = Uniform(-1, 1);
    const double angle = Uniform(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  Eigen::Quaterniond Rotation() {
    return Eigen::Quaterniond(Eigen::AngleAxisd(Uniform(0, 6), Direction()));
  }

 private:
  std::mt19937_64 bits_;
};

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

/** Two bodies that fly at each other without gravity. */
struct Collision {
  std::array<BodyDefinition, 2> bodies;
  double h;

  double EnergyOf(const World& world) const {
    double energy = 0;
    for (int i = 0; i < 2; ++i) {
      const BodyDefinition& body = bodies[static_cast<std::size_t>(i)];
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
  auto& [body, target] = collision.bodies;
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

INSTANTIATE_TEST_SUITE_P(, EnergyOfCollisions, testing::Bool(), [](const auto& test) {
  return test.param ? "Continuous" : "Discrete";
});

// For 10⁵ cases: RC_PARAMS=max_success=100000.
RC_GTEST_PROP(EnergyOfRandomCollisions, NeverRises, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto continuous = *rc::gen::arbitrary<bool>();
  RC_ASSERT(GreatestGain(RandomCollision(seed), continuous) <= kRounding);
}

}  // namespace
}  // namespace cookbook
