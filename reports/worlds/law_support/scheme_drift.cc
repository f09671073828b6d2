#include "reports/worlds/law_support/scheme_drift.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

/** Returns the change of the angular momentum of a body in a step of `h` [s]. [N m s] */
double MomentumChange(const Spin& spin, double h,
                      const std::optional<double>& documented) {
  if (documented) return *documented * spin.L.norm();
  const Eigen::Vector3d torque = spin.w.cross(spin.L);
  const Eigen::Vector3d w_dot = -torque.cwiseQuotient(spin.inertia);
  const Eigen::Vector3d half = spin.w.cross(torque) / 2;
  return h * h * std::max((w_dot.cross(spin.L) - half).norm(), half.norm());
}

/** Returns the change of the energy of a body in a step of `h` [s]. [J] */
double EnergyChange(const Spin& spin, double h, const std::optional<double>& documented) {
  if (documented) return *documented * spin.w.dot(spin.L) / 2;
  const Eigen::Vector3d torque = spin.w.cross(spin.L);
  return h * h * torque.dot(torque.cwiseQuotient(spin.inertia)) / 2;
}

template <typename Change>
std::vector<double> GyroscopicDrift(const Motion& motion, const AllowedMotion& allowed,
                                    const Subjects& subjects, const Change& change) {
  const double h = motion.world.dt;
  return IntegralAlong(allowed, [&](const WorldState& state) {
    double sum = 0;
    for (const int i : subjects.bodies) {
      sum += change(SpinOf(motion.world, state, i), h,
                    motion.oracle.documented_rotation_error) /
             h;
    }
    return sum;
  });
}

}  // namespace

std::vector<double> GyroscopicMomentumDrift(const Motion& motion,
                                            const AllowedMotion& allowed,
                                            const Subjects& subjects) {
  return GyroscopicDrift(motion, allowed, subjects, MomentumChange);
}

std::vector<double> GyroscopicEnergyDrift(const Motion& motion,
                                          const AllowedMotion& allowed,
                                          const Subjects& subjects) {
  return GyroscopicDrift(motion, allowed, subjects, EnergyChange);
}

std::vector<double> RodMomentumDrift(const Motion& motion, const AllowedMotion& allowed,
                                     const Subjects& subjects) {
  return IntegralAlong(allowed, [&](const WorldState& state) {
    double sum = 0;
    ForEachRod(motion.world, state, subjects, [&](const TurningRod& rod) {
      sum += motion.world.dt * rod.mass * std::pow(rod.speed, 3) / (2 * rod.length);
    });
    return sum;
  });
}

std::vector<double> RodEnergyDrift(const Motion& motion, const AllowedMotion& allowed,
                                   const Subjects& subjects) {
  return IntegralAlong(allowed, [&](const WorldState& state) {
    double sum = 0;
    ForEachRod(motion.world, state, subjects, [&](const TurningRod& rod) {
      sum += motion.world.dt * rod.mass * std::pow(rod.speed, 4) /
             (2 * rod.length * rod.length);
    });
    return sum;
  });
}

std::vector<double> IntegralAlong(const AllowedMotion& allowed,
                                  const std::function<double(const WorldState&)>& rate) {
  const std::vector<double>& times = allowed.times();
  std::vector<double> integral;
  double last_rate = 0;
  for (std::size_t s = 0; s < times.size(); ++s) {
    const double this_rate = rate(allowed.At(s));
    integral.push_back(s == 0 ? 0
                              : integral.back() + (times[s] - times[s - 1]) *
                                                      std::max(last_rate, this_rate));
    last_rate = this_rate;
  }
  return integral;
}

}  // namespace touchstone
