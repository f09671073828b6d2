#include "reports/worlds/law_support/scheme_drift.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "reports/worlds/law_support/error_laws.h"
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

/** Returns the highest angular speed of a free body with the energy of `spin`,
 √(2 E/I_min). [rad/s] */
double HighestSpeed(const Spin& spin) {
  return std::sqrt(std::max(0.0, spin.w.dot(spin.L)) / spin.inertia.minCoeff());
}

/** Returns whether the body may precess by more than half a radian in `time` [s], so that
 it may tumble between two samples at rates that neither shows. */
bool MayTumble(const Spin& spin, double time) {
  const double least = spin.inertia.minCoeff();
  return (spin.inertia.maxCoeff() - least) / least * HighestSpeed(spin) * time > 0.5;
}

/** Returns the largest change in a step during a free rotation. The gyroscopic torque
 about axis k is (I_i − I_j) ω_i ω_j, at most |I_i − I_j| E/√(I_i I_j): no more than at
 the highest speed about an axis midway between i and j. The three axes are summed. That
 bounds the change of energy, and that of angular momentum to a factor of √2, which the
 factor of safety of the laws covers. */
template <typename Change>
double ChangeOfTumble(const Spin& spin, double h, const Change& change) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    Spin midway = spin;
    midway.w.setConstant(HighestSpeed(spin) / std::numbers::sqrt2);
    midway.w[k] = 0;
    midway.L = midway.inertia.cwiseProduct(midway.w);
    sum += change(midway, h, std::nullopt);
  }
  return sum;
}

template <typename Change>
std::vector<double> GyroscopicDrift(const Motion& motion, const AllowedMotion& allowed,
                                    const Subjects& subjects, const Change& change) {
  const double h = motion.world.dt;
  const double spacing = SampleSpacing(motion.world);
  return IntegralAlong(allowed, [&](const WorldState& state) {
    double sum = 0;
    for (const int i : subjects.bodies) {
      const Spin spin = SpinOf(motion.world, state, i);
      const auto& documented = motion.oracle.documented_rotation_error;
      const bool is_hidden = !documented && spacing > h && MayTumble(spin, spacing);
      sum +=
          (is_hidden ? ChangeOfTumble(spin, h, change) : change(spin, h, documented)) / h;
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

std::vector<double> ImpactEnergyDrift(const Motion& motion, const AllowedMotion& allowed,
                                      const Subjects& subjects) {
  const World& world = motion.world;
  const std::vector<double>& times = allowed.times();
  std::vector<double> drift(times.size(), 0);
  for (std::size_t s = 1; s < times.size(); ++s) {
    drift[s] = drift[s - 1];
    for (const int index : subjects.bodies) {
      const auto i = static_cast<std::size_t>(index);
      const RigidBody& body = world.bodies[i];
      if (!body.collides || std::holds_alternative<Sphere>(body.placed.shape)) continue;
      const double R = BoundingRadius(body.placed.shape);
      double acceleration = 0;
      for (const std::size_t k : {s - 1, s}) {
        const Spin spin = SpinOf(world, allowed.At(k), index);
        acceleration = std::max(
            acceleration, R * (spin.w.squaredNorm() +
                               spin.w.cross(spin.L).cwiseQuotient(spin.inertia).norm()));
      }
      const Eigen::Vector3d J_W =
          body.mass * (allowed.At(s).bodies[i].v_WB - allowed.At(s - 1).bodies[i].v_WB) -
          (times[s] - times[s - 1]) * (body.mass * world.gravity_W + body.force_W);
      drift[s] += J_W.norm() * world.dt * acceleration / 2;
    }
  }
  return drift;
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
