// Bodies on rods that hit the ground and each other never gain energy: neither in an
// impact, nor while they touch.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/dynamics/world/world.h"
#include "tests/engine/dynamics/random.h"

namespace cookbook {
namespace {

using Eigen::Vector3d;

/** Energy that a step may add, as a fraction of the kinetic energy and that of a fall by
 a metre. The joints are right to 1e-14 of the velocities, the work of the contacts to
 1e-13 of their greatest terms; a stiff linkage may move by several times what it keeps.
 */
constexpr double kStepRounding = 1e-11;

/** A linkage: bodies on rods that form trees and loops, above the ground. */
struct Linkage {
  std::vector<BodyDefinition> bodies;  ///< The first is the ground.
  std::vector<DistanceJoint> rods;
  Vector3d gravity_W = Vector3d::Zero();
  double h = 0;
  double mass = 0;

  /** Calls `visit(body, state, L)` for each moving body, with the angular momentum. */
  template <class Visit>
  void ForEachBody(const World& world, const Visit& visit) const {
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const BodyState& state = world.state(static_cast<int>(i));
      const Vector3d w_B = state.q_WB.conjugate() * state.w_WB;
      const Vector3d L_B =
          PrincipalInertia(bodies[i].shape, bodies[i].mass).cwiseProduct(w_B);
      visit(bodies[i], state, Vector3d(state.q_WB * L_B));
    }
  }
  double KineticEnergy(const World& world) const {
    double energy = 0;
    ForEachBody(world, [&](const BodyDefinition& body, const BodyState& state,
                           const Vector3d& L) {
      energy += (body.mass * state.v_WB.squaredNorm() + state.w_WB.dot(L)) / 2;
    });
    return energy;
  }
  double Energy(const World& world) const {
    double energy = KineticEnergy(world);
    ForEachBody(world,
                [&](const BodyDefinition& body, const BodyState& state, const Vector3d&) {
                  energy -= body.mass * gravity_W.dot(state.p_WB);
                });
    return energy;
  }
};

BodyDefinition AnyBody(Random& random) {
  BodyDefinition body;
  const double size = random.Uniform(0.1, 0.4);
  const int kind = random.Below(3);
  const double y = random.LogUniform(0.05, 1);
  const double z = random.LogUniform(0.05, 1);
  if (kind == 0) {
    body.shape = Sphere{size};
  } else {
    body.shape = Box{size * Vector3d(1, kind == 1 ? y : 0.05, kind == 1 ? z : 0.05)};
  }
  body.mass = random.LogUniform(0.1, 10);
  body.state.q_WB = random.Rotation();
  return body;
}

double RadiusOf(const BodyDefinition& body) {
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) return sphere->radius;
  return std::get<Box>(body.shape).half_extents.norm();
}

/** Returns the centre of the body, or a point inside. Body frame. [m] */
Vector3d AnyAnchor(const BodyDefinition& body, Random& random) {
  const bool is_centre = random.Below(4) == 0;
  const Vector3d direction = random.Direction();
  if (is_centre) return Vector3d::Zero();
  if (const auto* sphere = std::get_if<Sphere>(&body.shape))
    return sphere->radius * direction;
  return std::get<Box>(body.shape).half_extents.cwiseProduct(direction);
}

void AddRod(int A, int B, Random& random, Linkage& linkage) {
  const auto at = [&](int i) -> const BodyDefinition& {
    return linkage.bodies[static_cast<std::size_t>(i)];
  };
  const Vector3d on_A = AnyAnchor(at(A), random);
  const Vector3d on_B = AnyAnchor(at(B), random);
  const Vector3d a_W = at(A).state.p_WB + at(A).state.q_WB * on_A;
  const Vector3d b_W = at(B).state.p_WB + at(B).state.q_WB * on_B;
  linkage.rods.push_back({{A, on_A}, {B, on_B}, (b_W - a_W).norm()});
}

Linkage AnyLinkage(std::uint64_t seed, bool has_gravity) {
  Random random(seed);
  Linkage linkage;
  linkage.h = random.LogUniform(1e-3, 1.0 / 30);
  if (has_gravity) linkage.gravity_W = {0, 0, -9.82};
  BodyDefinition& ground = linkage.bodies.emplace_back();
  ground.shape = HalfSpace{};
  ground.mass = 0;
  const int count = 2 + random.Below(5);
  const bool last_is_loose = random.Coin();
  for (int i = 1; i <= count; ++i) {
    BodyDefinition body = AnyBody(random);
    const double radius = RadiusOf(body);
    const int parent = i == 1 ? 0 : 1 + random.Below(i - 1);
    double distance = radius + random.Uniform(0.05, 0.5);
    if (i > 1) {
      const BodyDefinition& held = linkage.bodies[static_cast<std::size_t>(parent)];
      distance += RadiusOf(held);
      body.state.p_WB = held.state.p_WB + distance * random.Direction();
    } else {
      body.state.p_WB = {0, 0, distance};
    }
    const auto overlaps = [&](const BodyDefinition& other) {
      return other.mass > 0 && (other.state.p_WB - body.state.p_WB).norm() <
                                   RadiusOf(other) + radius + 0.01;
    };
    while (std::any_of(linkage.bodies.begin(), linkage.bodies.end(), overlaps) ||
           body.state.p_WB.z() < radius + 0.01) {
      body.state.p_WB += 0.3 * random.Direction() + Vector3d(0, 0, 0.1);
    }
    linkage.mass += body.mass;
    linkage.bodies.push_back(body);
    if (i > 1 && !(last_is_loose && i == count && count > 2))
      AddRod(parent, i, random, linkage);
  }
  for (int loops = random.Below(3); loops > 0; --loops) {
    const int A = 1 + random.Below(count);
    AddRod(A, 1 + A % count, random, linkage);
  }
  // One at a time: compilers evaluate the operands of a product in different orders.
  const Vector3d direction = random.Direction();
  const double speed = random.Uniform(0, 8);
  const Vector3d v_W = speed * (0.7 * direction - Vector3d(0, 0, 1));
  const Vector3d axis = random.Direction();
  const double spin = random.Uniform(0, 6);
  const Vector3d w_W = spin * axis;
  const bool are_alike = random.Coin();
  const double e = std::clamp(random.Uniform(-0.3, 1.3), 0.0, 1.0);
  const double mu = std::clamp(random.Uniform(-0.3, 1.3), 0.0, 1.0);
  for (BodyDefinition& body : linkage.bodies) {
    body.restitution = are_alike ? e : random.Uniform(0, 1);
    body.friction = are_alike ? mu : random.Uniform(0, 1);
    if (body.mass == 0) continue;
    body.state.w_WB = w_W;
    body.state.v_WB = v_W + w_W.cross(body.state.p_WB);
  }
  if (last_is_loose) linkage.bodies.back().state.v_WB *= -0.5;
  return linkage;
}

/** Returns the greatest energy that a step adds, as a fraction of the energy at the start
 and that of a fall by a metre. */
double GreatestGain(const Linkage& linkage, int steps) {
  Settings settings;
  settings.gravity_W = linkage.gravity_W;
  // Position correction lifts bodies; without it the potential energy has no part in it.
  settings.position_correction_fraction = 1e-15;
  World world(settings);
  for (const BodyDefinition& body : linkage.bodies) world.AddBody(body);
  for (const DistanceJoint& rod : linkage.rods) world.AddJoint(rod);
  const double scale =
      linkage.KineticEnergy(world) + linkage.mass * linkage.gravity_W.norm();
  double before = linkage.Energy(world);
  double gain = 0;
  for (int k = 0; k < steps; ++k) {
    world.Step(linkage.h);
    const double after = linkage.Energy(world);
    gain = std::max(gain, (after - before) / scale);
    before = after;
    if (world.diverged()) return 1e9;
  }
  return gain;
}

TEST(LinkageEnergy, NeverRises) {
  for (std::uint64_t seed = 0; seed < 26; ++seed)
    EXPECT_LE(GreatestGain(AnyLinkage(seed, seed % 2 == 0), 60), kStepRounding) << seed;
}

// Linkages with bodies that spin by a third of a radian in a step and more, and touch.
// The joint solver ended with iterations of contacts, and left the rods unsolved.
TEST(LinkageEnergy, NeverRisesWhereContactsAndSpinningBodiesAreSolvedInTurns) {
  EXPECT_LE(GreatestGain(AnyLinkage(140000497, true), 20), kStepRounding);
  EXPECT_LE(GreatestGain(AnyLinkage(420001337, true), 20), kStepRounding);
  EXPECT_LE(GreatestGain(AnyLinkage(565001772, false), 20), kStepRounding);
}

// For 10⁴ cases: RC_PARAMS=max_success=10000.
RC_GTEST_PROP(LinkageEnergyOfRandomLinkages, NeverRises, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto has_gravity = *rc::gen::arbitrary<bool>();
  RC_ASSERT(GreatestGain(AnyLinkage(seed, has_gravity), 20) <= kStepRounding);
}

}  // namespace
}  // namespace cookbook
