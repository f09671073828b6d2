#include "reports/worlds/law_support/allowed_motion.h"

#include <algorithm>
#include <cmath>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Largest kinetic energy of a motion that has drifted, over that of the truth. [-] */
constexpr double kDrifted = 2;

/** Returns the energy of all springs at the start, cloths included. [J] */
double SpringEnergyAtStart(World world, const Subjects& everything) {
  world.gravity_W.setZero();
  for (RigidBody& body : world.bodies) body.force_W.setZero();
  return EnergyOf(world, StateAtStart(world), everything).potential;
}

/** Returns the most by which a push raises √(2H). [√J] */
double LiftOf(const World& world, const Push& push) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(push.body)];
  // The orientation at the push is unknown: the longest lever and the least inertia.
  const double turn = push.p_BoP.norm() * push.J_W.norm();
  return std::sqrt(push.J_W.squaredNorm() / body.mass +
                   turn * turn / InertiaOf(body).minCoeff());
}

void Slow(WorldState& state, double factor) {
  for (BodyState& body : state.bodies) {
    body.v_WB *= factor;
    body.w_WB *= factor;
  }
  for (PointState& point : state.particles) point.v_W *= factor;
  for (PointState& point : state.nodes) point.v_W *= factor;
}

}  // namespace

AllowedMotion::AllowedMotion(const Motion& motion)
    : states_(motion.trajectory.samples), times_(&motion.trajectory.times) {
  const World& world = motion.world;
  const Subjects everything = SubjectsOf(world, {});
  const Energy start = EnergyOf(world, StateAtStart(world), everything);
  const double loads = SquaredLoadsOf(world, everything);
  const double h = world.dt;
  const double H_0 = start.kinetic + SpringEnergyAtStart(world, everything);
  double most = 0;
  kinetic_.reserve(states_.size());
  kinetic_between_.reserve(states_.size());
  for (std::size_t s = 0; s < states_.size(); ++s) {
    const double t = times()[s] + h;
    double root = std::sqrt(2 * H_0) + t * std::sqrt(loads);
    for (const Push& push : world.pushes)
      if (push.time < t) root += LiftOf(world, push);
    double allowed = root * root / 2;
    kinetic_between_.push_back(allowed);
    const Energy energy = EnergyOf(world, states_[s], everything);
    if (world.pushes.empty()) {
      const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
      allowed = std::min(allowed, std::max(0.0, start.total() - energy.potential) +
                                      std::max(0.0, -h * energy.power) +
                                      kSafety * h * h * loads + rounding * start.size);
    }
    if (energy.kinetic > kDrifted * allowed)
      Slow(states_[s], std::sqrt(kDrifted * allowed / energy.kinetic));
    most = std::max(most, allowed);
    kinetic_.push_back(most);
  }
}

}  // namespace touchstone
