// Chains and trees of rods never gain energy, whatever their masses, spins and steps are.
// A light body between a support and a heavy one swings far faster than a step: with
// tension T, mass m and length ℓ its frequency is √(2 T/(m ℓ)), hundreds of radians per
// second.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"
#include "tests/engine/dynamics/random.h"

namespace cookbook {
namespace {

using Eigen::Vector3d;

/** Relative energy that a step may add by rounding. The lengths are right to 1e-15 of the
 places of the anchors, and the velocities to 1e-14 of themselves or of their changes; the
 energy of a step in five parts then has an error of at most about 20 times that. */
constexpr double kStepRounding = 20 * 1e-14;
/** Error of a length. Up to 100 times 1e-15 of the places, which are within 10 m, in each
 part of a step; position correction leaves 0.8 of it, so that five times that add up. [m]
 */
constexpr double kLengthError = 5 * 100 * 1e-15 * 10;

/** Where rods are attached. */
enum class Bodies { kPoints, kAtCentres, kAtArms };

/** Bodies that rods connect to a chain or a tree. */
struct Mechanism {
  bool hangs = true;  ///< From a support, under gravity. Else it is free.
  std::vector<BodyDefinition> bodies;
  std::vector<DistanceJoint> rods;
  double h = 0;
  double max_ratio = 1;  ///< Of two masses.

  Vector3d gravity_W() const { return {0, hangs ? -9.82 : 0, 0}; }

  double KineticEnergy(const World& world) const {
    double energy = 0;
    ForEachBody(world, [&](const BodyDefinition& body, const BodyState& state) {
      const Vector3d w_B = state.q_WB.conjugate() * state.w_WB;
      energy += body.mass * state.v_WB.squaredNorm() / 2 +
                w_B.dot(MomentsOf(body).cwiseProduct(w_B)) / 2;
    });
    return energy;
  }
  double Energy(const World& world) const {
    double energy = KineticEnergy(world);
    ForEachBody(world, [&](const BodyDefinition& body, const BodyState& state) {
      energy -= body.mass * gravity_W().dot(state.p_WB);
    });
    return energy;
  }
  Vector3d Momentum(const World& world) const {
    Vector3d momentum = Vector3d::Zero();
    ForEachBody(world, [&](const BodyDefinition& body, const BodyState& state) {
      momentum += body.mass * state.v_WB;
    });
    return momentum;
  }
  Vector3d AngularMomentum(const World& world) const {
    Vector3d momentum = Vector3d::Zero();
    ForEachBody(world, [&](const BodyDefinition& body, const BodyState& state) {
      const Vector3d w_B = state.q_WB.conjugate() * state.w_WB;
      const Vector3d L_B = MomentsOf(body).cwiseProduct(w_B);
      momentum += body.mass * state.p_WB.cross(state.v_WB) + state.q_WB * L_B;
    });
    return momentum;
  }
  /** The greatest error of a length. [m] */
  double LengthError(const World& world) const {
    const auto at = [&](const Anchor& anchor) {
      if (anchor.body < 0) return anchor.point;
      const BodyState& state = world.state(anchor.body);
      return Vector3d(state.p_WB + state.q_WB * anchor.point);
    };
    double greatest = 0;
    for (const DistanceJoint& rod : rods) {
      const double length = (at(rod.B) - at(rod.A)).norm();
      greatest = std::max(greatest, std::abs(length - rod.length));
    }
    return greatest;
  }

 private:
  static Vector3d MomentsOf(const BodyDefinition& body) {
    if (std::holds_alternative<Point>(body.shape)) return Vector3d::Zero();
    return PrincipalInertia(body.shape, body.mass);
  }
  template <class Visit>
  void ForEachBody(const World& world, const Visit& visit) const {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      visit(bodies[i], world.state(static_cast<int>(i)));
  }
};

BodyDefinition AnyBody(Bodies kind, double speed, double spin, Random& random) {
  BodyDefinition body;
  body.collides = false;
  body.state.q_WB = random.Rotation();
  body.state.v_WB = speed * random.Direction();
  const int shape = kind == Bodies::kPoints ? 0 : random.Below(3);
  if (shape == 0) {
    body.shape = Point{};
    return body;
  }
  body.state.w_WB = spin * random.Direction();
  if (shape == 1) {
    body.shape = Sphere{random.Uniform(0.1, 0.3)};
  } else {
    const double x = random.Uniform(0.05, 0.3);
    const double y = random.Uniform(0.05, 0.3);
    body.shape = Box{{x, y, random.Uniform(0.05, 0.3)}};
  }
  return body;
}

/** Returns a point of the body to which a rod may be attached. Body frame. [m] */
Vector3d AnyAnchor(const BodyDefinition& body, Bodies kind, Random& random) {
  const Vector3d direction = random.Direction();
  if (kind != Bodies::kAtArms || std::holds_alternative<Point>(body.shape))
    return Vector3d::Zero();
  return 0.1 * direction;
}

Mechanism AnyMechanism(Bodies kind, bool hangs, Random& random) {
  Mechanism mechanism;
  mechanism.hangs = hangs;
  mechanism.h = random.LogUniform(1e-3, 1.0 / 30);
  const bool is_tree = random.Coin();
  const double ratio = random.LogUniform(1, 1e4);
  const double speed = random.Coin() ? random.LogUniform(0.1, 5) : 0;
  const double spin = random.Coin() ? random.LogUniform(0.1, 10) : 0;
  const int count = 2 + random.Below(3);
  double lightest = std::numeric_limits<double>::infinity();
  double heaviest = 0;
  bool starts_heavy = false;
  for (int i = 0; i < count; ++i) {
    BodyDefinition body = AnyBody(kind, speed, spin, random);
    // At least one heavy and one light body, in any order, so that the ratio is both
    // ways.
    const bool coin = random.Coin();
    const bool is_heavy = i == 1 ? !starts_heavy : coin;
    if (i == 0) starts_heavy = is_heavy;
    body.mass = random.LogUniform(0.5, 2) * (is_heavy ? ratio : 1);
    lightest = std::min(lightest, body.mass);
    heaviest = std::max(heaviest, body.mass);
    const int parent = is_tree && i > 0 ? random.Below(i) : i - 1;
    Anchor above{parent, Vector3d::Zero()};
    Vector3d above_W = Vector3d::Zero();
    if (parent >= 0) {
      const BodyDefinition& held = mechanism.bodies[static_cast<std::size_t>(parent)];
      above.point = AnyAnchor(held, kind, random);
      above_W = held.state.p_WB + held.state.q_WB * above.point;
    }
    const Vector3d point = AnyAnchor(body, kind, random);
    const double length = random.Uniform(0.3, 1.5);
    body.state.p_WB = above_W + length * random.Direction() - body.state.q_WB * point;
    mechanism.bodies.push_back(body);
    if (parent >= 0 || hangs) mechanism.rods.push_back({above, {i, point}, length});
  }
  mechanism.max_ratio = heaviest / lightest;
  return mechanism;
}

/** Steps `count` mechanisms for half a second each and expects what their physics keeps.
 */
void ExpectConservation(Bodies kind, bool hangs, int count) {
  int ratios_beyond_100 = 0;
  for (int seed = 0; seed < count; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Mechanism mechanism = AnyMechanism(kind, hangs, random);
    ratios_beyond_100 += mechanism.max_ratio > 100;
    Settings settings;
    settings.gravity_W = mechanism.gravity_W();
    World world(settings);
    double mass = 0;
    for (const BodyDefinition& body : mechanism.bodies) {
      world.AddBody(body);
      mass += body.mass;
    }
    for (const DistanceJoint& rod : mechanism.rods) world.AddJoint(rod);
    // Random velocities along the rods are an impact, which loses energy.
    world.Step(1e-9 * mechanism.h);
    // Bodies may fall by about a metre, which is far less than the whole length.
    const double scale = mechanism.KineticEnergy(world) + mass * (hangs ? 9.82 : 0);
    const Vector3d momentum = mechanism.Momentum(world);
    const Vector3d angular = mechanism.AngularMomentum(world);
    // The momenta of single bodies, of which the sums are differences.
    const double momentum_scale = std::sqrt(2 * mass * scale);
    double lowest = mechanism.Energy(world);
    double gain = 0;
    double length_error = 0;
    const int steps = static_cast<int>(std::ceil(0.5 / mechanism.h));
    for (int k = 0; k < steps && !world.diverged(); ++k) {
      world.Step(mechanism.h);
      const double energy = mechanism.Energy(world);
      gain = std::max(gain, energy - lowest);
      lowest = std::min(lowest, energy);
      length_error = std::max(length_error, mechanism.LengthError(world));
    }
    const double granted = kStepRounding * steps;
    ASSERT_FALSE(world.diverged()) << "seed " << seed;
    ASSERT_LE(gain, granted * scale) << "seed " << seed << ", h = " << mechanism.h;
    ASSERT_LE(length_error, kLengthError) << "seed " << seed << ", h = " << mechanism.h;
    if (hangs) continue;
    // Each impulse acts on both bodies of a rod.
    ASSERT_LE((mechanism.Momentum(world) - momentum).norm(), granted * momentum_scale)
        << "seed " << seed;
    // Lever arms are within 10 m.
    ASSERT_LE((mechanism.AngularMomentum(world) - angular).norm(),
              granted * 10 * momentum_scale)
        << "seed " << seed;
  }
  // A third of the mechanisms or more, or the test has missed its subject.
  EXPECT_GE(3 * ratios_beyond_100, count);
}

TEST(RodEnergy, ChainsOfPointsNeverGainEnergy) {
  ExpectConservation(Bodies::kPoints, true, 60);
}

TEST(RodEnergy, ChainsOfBodiesHeldAtTheirCentresNeverGainEnergy) {
  ExpectConservation(Bodies::kAtCentres, true, 60);
}

TEST(RodEnergy, ChainsOfBodiesHeldAtArmsNeverGainEnergy) {
  ExpectConservation(Bodies::kAtArms, true, 60);
}

TEST(RodEnergy, FreeChainsKeepMomentaAndNeverGainEnergy) {
  ExpectConservation(Bodies::kAtArms, false, 60);
}

}  // namespace
}  // namespace cookbook
