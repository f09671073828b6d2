#include "reports/worlds/law_support/scheme_drift.h"

#include <algorithm>
#include <cmath>

#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** The rotation of one body, in its own frame. */
struct Spin {
  Eigen::Vector3d inertia;
  Eigen::Vector3d w;
  Eigen::Vector3d L;
};

Spin SpinOf(const World& world, const WorldState& state, int index) {
  const BodyState& at = state.bodies[static_cast<std::size_t>(index)];
  Spin spin{InertiaOf(world.bodies[static_cast<std::size_t>(index)]),
            at.q_WB.conjugate() * at.w_WB, Eigen::Vector3d::Zero()};
  spin.L = spin.inertia.cwiseProduct(spin.w);
  return spin;
}

double InverseMassOf(const World& world, const Anchor& anchor) {
  double mass = 0;
  if (anchor.on == AnchorKind::kBody)
    mass = world.bodies[static_cast<std::size_t>(anchor.index)].mass;
  if (anchor.on == AnchorKind::kParticle)
    mass = world.particles[static_cast<std::size_t>(anchor.index)].mass;
  return mass > 0 ? 1 / mass : 0;
}

/** A rotating rod: its reduced mass and the relative speed of its ends. */
struct TurningRod {
  double mass;
  double speed;
  double length;
};

template <typename Visit>
void ForEachRod(const World& world, const WorldState& state, const Subjects& subjects,
                const Visit& visit) {
  for (const DistanceJoint& joint : world.joints) {
    if (!Has(subjects, joint.A) && !Has(subjects, joint.B)) continue;
    const PointState A = StateOf(world, state, joint.A);
    const PointState B = StateOf(world, state, joint.B);
    const double inverse_mass =
        InverseMassOf(world, joint.A) + InverseMassOf(world, joint.B);
    visit(TurningRod{1 / inverse_mass, (B.v_W - A.v_W).norm(), joint.length});
  }
}

}  // namespace

double GyroscopicMomentumRate(const World& world, const WorldState& state,
                              const Subjects& subjects) {
  double sum = 0;
  for (const int i : subjects.bodies) {
    const Spin spin = SpinOf(world, state, i);
    const Eigen::Vector3d torque = spin.w.cross(spin.L);
    const Eigen::Vector3d w_dot = -torque.cwiseQuotient(spin.inertia);
    const Eigen::Vector3d half = spin.w.cross(torque) / 2;
    sum += std::max((w_dot.cross(spin.L) - half).norm(), half.norm());
  }
  return sum;
}

double GyroscopicPowerRate(const World& world, const WorldState& state,
                           const Subjects& subjects) {
  double sum = 0;
  for (const int i : subjects.bodies) {
    const Spin spin = SpinOf(world, state, i);
    const Eigen::Vector3d torque = spin.w.cross(spin.L);
    sum += torque.dot(torque.cwiseQuotient(spin.inertia)) / 2;
  }
  return sum;
}

double JointMomentumRate(const World& world, const WorldState& state,
                         const Subjects& subjects) {
  double sum = 0;
  ForEachRod(world, state, subjects, [&](const TurningRod& rod) {
    sum += rod.mass * std::pow(rod.speed, 3) / (2 * rod.length);
  });
  return sum;
}

double JointPowerRate(const World& world, const WorldState& state,
                      const Subjects& subjects) {
  double sum = 0;
  ForEachRod(world, state, subjects, [&](const TurningRod& rod) {
    sum += rod.mass * std::pow(rod.speed, 4) / (2 * rod.length * rod.length);
  });
  return sum;
}

std::vector<double> IntegralAlong(const Trajectory& trajectory,
                                  const std::function<double(const WorldState&)>& rate) {
  std::vector<double> integral;
  double last_rate = 0;
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const double this_rate = rate(trajectory.samples[s]);
    integral.push_back(s == 0 ? 0
                              : integral.back() +
                                    (trajectory.times[s] - trajectory.times[s - 1]) *
                                        std::max(last_rate, this_rate));
    last_rate = this_rate;
  }
  return integral;
}

}  // namespace touchstone
