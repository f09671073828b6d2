#include "reports/worlds/law_support/energy_bound.h"

#include <algorithm>
#include <cmath>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/parting_work.h"
#include "reports/worlds/law_support/scheme_drift.h"

namespace touchstone {
namespace {

/** The share of the effect of a rule that must be known for it to be recognised. [-] */
constexpr double kSmallPart = 0.1;

/** The energy that was reflected from one sample to the next, and its uncertainty. [J] */
struct Reflected {
  double energy = 0;
  double slack = 0;
};

Reflected ReflectedGravity(const World& world, const WorldState& from,
                           const WorldState& to, const Subjects& subjects) {
  Reflected sum;
  const auto add = [&](double mass, const Eigen::Vector3d& before,
                       const Eigen::Vector3d& after) {
    const double falling = world.gravity_W.dot(before);
    const double rising = -world.gravity_W.dot(after);
    // Gravity has acted again by the sample after the bounce, so the faster speed is
    // nearer to that of the bounce.
    if (falling <= 0 || rising <= 0) return;
    sum.energy += mass * world.dt * std::max(falling, rising);
    sum.slack +=
        mass * world.dt * 2 * world.gravity_W.squaredNorm() * SampleSpacing(world);
  };
  for (const int i : subjects.bodies) {
    const auto index = static_cast<std::size_t>(i);
    add(world.bodies[index].mass, from.bodies[index].v_WB, to.bodies[index].v_WB);
  }
  for (const int i : subjects.particles) {
    const auto index = static_cast<std::size_t>(i);
    add(world.particles[index].mass, from.particles[index].v_W, to.particles[index].v_W);
  }
  return sum;
}

}  // namespace

double EnergyAlong::Tolerance(std::size_t from, std::size_t to) const {
  return oscillations[to] + std::min(drifts[to] - drifts[from], most_kinetic[to]);
}

std::vector<std::array<std::size_t, 2>> EnergyAlong::WorstEarlier(double sign) const {
  std::vector<std::array<std::size_t, 2>> worst;
  std::size_t extreme = 0;
  std::size_t undrifted = 0;
  const auto beyond_drift = [&](std::size_t s) { return sign * Earlier(s) - drifts[s]; };
  for (std::size_t s = 0; s < energies.size(); ++s) {
    worst.push_back({extreme, undrifted});
    if (sign * Earlier(s) < sign * Earlier(extreme)) extreme = s;
    if (beyond_drift(s) < beyond_drift(undrifted)) undrifted = s;
  }
  return worst;
}

bool EnergyAlong::ReflectsAfterGravity(double rise, std::size_t from,
                                       std::size_t to) const {
  const double gain = reflected_gravity[to] - reflected_gravity[from];
  // Such engines are semi-implicit, which conserves E − ½ h dU/dt to second order.
  const double oscillation = dt * (energies[to].power - energies[from].power) / 2;
  const double slack = second_orders[to] + drifts[to] - drifts[from] +
                       kSafety * (reflected_slack[to] - reflected_slack[from]);
  return slack <= kSmallPart * gain && std::abs(rise - oscillation - gain) <= slack;
}

EnergyAlong EnergyAlongOf(const Motion& motion, const Subjects& subjects) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const AllowedMotion allowed(motion);
  const double second_order = world.dt * world.dt * SquaredLoadsOf(world, subjects);
  const std::vector<double> gyroscopic = GyroscopicEnergyDrift(motion, allowed, subjects);
  const std::vector<double> rods = RodEnergyDrift(motion, allowed, subjects);
  const std::vector<double> impacts = ImpactEnergyDrift(motion, allowed, subjects);
  const double overlaps = WorkOfParting(motion, subjects);
  EnergyAlong along;
  along.dt = world.dt;
  along.at_start = EnergyOf(world, StateAtStart(world), subjects).total();
  double power = 0;
  double size = 0;
  Reflected reflected;
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const WorldState& state = trajectory.samples[s];
    const Energy slowed = EnergyOf(world, allowed.At(s), subjects);
    power = std::max(power, std::abs(slowed.power));
    size = std::max(size, slowed.size);
    if (s > 0) {
      const Reflected more =
          ReflectedGravity(world, trajectory.samples[s - 1], state, subjects);
      reflected.energy += more.energy;
      reflected.slack += more.slack;
    }
    along.energies.push_back(EnergyOf(world, state, subjects));
    const double floor =
        NoiseOfPositions(world, state, subjects, motion.oracle.unit_roundoff).energy;
    along.second_orders.push_back(kSafety * second_order + floor + overlaps +
                                  RoundingOf(motion.oracle, StepsBefore(motion, s)) *
                                      size);
    along.oscillations.push_back(kSafety * world.dt * power + along.second_orders.back());
    along.drifts.push_back(kSafety * (gyroscopic[s] + rods[s] + impacts[s]));
    along.most_kinetic.push_back(allowed.KineticEnergy(s));
    along.reflected_gravity.push_back(reflected.energy);
    along.reflected_slack.push_back(reflected.slack);
  }
  return along;
}

std::string BecauseOfEnergy() {
  return "1.5 × the error of semi-implicit Euler: ½ h dU/dt at both ends, h² |F|²/m, and "
         "½ h ∫ of the losses of the gyroscopic term and rods since the earlier sample; "
         "64 roundings per step; the work of moving apart what overlaps at the start; "
         "all at speeds that the truth allows";
}

}  // namespace touchstone
