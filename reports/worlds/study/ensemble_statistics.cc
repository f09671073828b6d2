#include "reports/worlds/study/ensemble_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/distributions/students_t.hpp>

#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** The significance level: the probability that chance is treated as a difference. [-] */
constexpr double kChance = 1e-3;

/** Relative rounding error of a mean. [-] */
constexpr double kRounded = 1e-9;

Statistic StatisticOf(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  Statistic of;
  for (const double value : values) of.mean += value / count;
  double squares = 0;
  for (const double value : values) squares += (value - of.mean) * (value - of.mean);
  of.deviation = std::sqrt(squares / (count - 1));
  return of;
}

/** Returns Σ m |x − c|²/Σ m over the bodies and particles. [m²] */
double SquaredWidth(const World& world, const WorldState& state, const Subjects& subjects,
                    const Eigen::Vector3d& c_W) {
  double squares = 0;
  for (const int i : subjects.bodies) {
    const auto body = static_cast<std::size_t>(i);
    squares += world.bodies[body].mass * (state.bodies[body].p_WB - c_W).squaredNorm();
  }
  for (const int i : subjects.particles) {
    const auto particle = static_cast<std::size_t>(i);
    squares += world.particles[particle].mass *
               (state.particles[particle].p_W - c_W).squaredNorm();
  }
  return squares / MassOf(world, subjects);
}

}  // namespace

EnsembleStatistics StatisticsOf(const World& world, std::span<const Trajectory> motions) {
  Subjects subjects = SubjectsOf(world, {});
  subjects.cloths.clear();  // Only positions of bodies and particles are jittered.
  if (motions.size() < 2 || !std::all_of(motions.begin(), motions.end(), IsWhole) ||
      !(MassOf(world, subjects) > 0)) {
    return {};
  }
  const double g = world.gravity_W.norm();
  const Eigen::Vector3d up =
      g > 0 ? Eigen::Vector3d(-world.gravity_W / g) : Eigen::Vector3d::UnitY();
  std::vector<double> energies;
  std::vector<double> heights;
  std::vector<double> widths;
  for (const Trajectory& motion : motions) {
    const WorldState& end = motion.samples.back();
    const Eigen::Vector3d centre = CentreOf(world, end, subjects);
    energies.push_back(EnergyOf(world, end, subjects).kinetic);
    heights.push_back(centre.dot(up));
    widths.push_back(std::sqrt(SquaredWidth(world, end, subjects, centre)));
  }
  return {static_cast<int>(motions.size()), StatisticOf(energies), StatisticOf(heights),
          StatisticOf(widths)};
}

bool Differ(const Statistic& a, int members_a, const Statistic& b, int members_b) {
  const double apart = std::abs(a.mean - b.mean);
  if (apart <= kRounded * std::max(std::abs(a.mean), std::abs(b.mean))) return false;
  // The variances of the two means, and the degrees of freedom of their sum.
  const double u = a.deviation * a.deviation / members_a;
  const double v = b.deviation * b.deviation / members_b;
  if (u + v == 0) return true;
  const double freedom =
      (u + v) * (u + v) / (u * u / (members_a - 1) + v * v / (members_b - 1));
  const boost::math::students_t distribution(freedom);
  return apart >
         boost::math::quantile(complement(distribution, kChance / 2)) * std::sqrt(u + v);
}

}  // namespace touchstone
