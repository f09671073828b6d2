#include "engine/dynamics/solver/restitution_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cookbook {
namespace {

/** Error of the work of an impulse, as a fraction of its greatest term: the rounding and
 the residual of the solver. */
constexpr double kResidual = 1e-13;

/** Returns the velocity of B relative to A at `p_W`. */
Eigen::Vector3d RelativeVelocity(const ContactPair& pair, const Eigen::Vector3d& p_W,
                                 const SolverBodies& bodies,
                                 std::span<const Velocity> velocities) {
  const auto velocity_of = [&](int body) -> Eigen::Vector3d {
    const auto i = static_cast<std::size_t>(body);
    const Eigen::Vector3d r_W = p_W - bodies.rigid_bodies[i].state.p_WB;
    return velocities[i].v + velocities[i].w.cross(r_W);
  };
  return velocity_of(pair.B) - velocity_of(pair.A);
}

/** The relative velocities at a contact. [m/s] */
struct Velocities {
  Eigen::Vector3d before;
  Eigen::Vector3d with_loads;  ///< After the step, without impulses.
  Eigen::Vector3d after;
};

Velocities VelocitiesAt(const ContactPair& pair, const Eigen::Vector3d& p_W,
                        const SolverBodies& bodies, std::span<const Velocity> free) {
  return {RelativeVelocity(pair, p_W, bodies, bodies.velocities_before),
          RelativeVelocity(pair, p_W, bodies, free),
          RelativeVelocity(pair, p_W, bodies, bodies.velocities)};
}

/** Returns the energy that an impulse adds beyond the work of the loads. [J] */
double AddedEnergy(const Eigen::Vector3d& J_W, const Velocities& u) {
  return (J_W.dot(u.before + u.after) - std::abs(J_W.dot(u.with_loads - u.before))) / 2;
}

std::size_t IslandOf(const ContactPair& pair, const SolverBodies& bodies,
                     std::span<const int> island_roots) {
  const int moving =
      bodies.is_static[static_cast<std::size_t>(pair.A)] != 0 ? pair.B : pair.A;
  return static_cast<std::size_t>(island_roots[static_cast<std::size_t>(moving)]);
}

}  // namespace

double FractionWithoutGain(double elastic, double inelastic, double curvature) {
  const double slope = inelastic - elastic - curvature;
  const double discriminant = slope * slope - 4 * curvature * elastic;
  if (discriminant < 0) return 1;
  const double root = std::sqrt(discriminant);
  return root > slope ? std::min(1.0, 2 * elastic / (root - slope)) : 1;
}

double RestitutionLimit::Island::Fraction() const {
  return elastic <= rounding ? 0 : FractionWithoutGain(elastic, inelastic, curvature);
}

double RestitutionLimit::Island::Scale() const {
  if (Fraction() < 1 || inelastic <= rounding) return 1;
  // A multiple f of J_0 adds f (inelastic − inelastic_work) + f² inelastic_work.
  return std::max(0.0, 1 - inelastic / inelastic_work);
}

bool RestitutionLimit::Exceeds(std::span<const ContactPair> pairs,
                               std::span<const ColouredPair> solved,
                               const SolverBodies& bodies, std::span<const Velocity> free,
                               std::span<const int> island_roots) {
  islands_.assign(bodies.rigid_bodies.size(), {});
  bool exceeds = false;
  for (const ColouredPair& at : solved) {
    const ContactPair& pair = pairs[static_cast<std::size_t>(at.pair)];
    Island& island = islands_[IslandOf(pair, bodies, island_roots)];
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
      const Eigen::Vector3d& p_WC = pair.manifold.contacts[k].p_WC;
      const Velocities u = VelocitiesAt(pair, p_WC, bodies, free);
      island.elastic += AddedEnergy(pair.J_W[k], u);
      island.rounding +=
          kResidual * pair.J_W[k].norm() * (u.before.norm() + u.after.norm());
    }
  }
  for (const Island& island : islands_)
    exceeds = exceeds || island.elastic > island.rounding;
  if (!exceeds) return false;
  elastic_.assign(pairs.begin(), pairs.end());
  elastic_velocities_.assign(bodies.velocities.begin(), bodies.velocities.end());
  free_.assign(free.begin(), free.end());
  return true;
}

void RestitutionLimit::Blend(std::span<ContactPair> pairs,
                             std::span<const ColouredPair> solved,
                             const SolverBodies& bodies,
                             std::span<const int> island_roots) {
  for (const ColouredPair& at : solved) {
    const auto p = static_cast<std::size_t>(at.pair);
    const ContactPair& pair = pairs[p];
    Island& island = islands_[IslandOf(pair, bodies, island_roots)];
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
      const Eigen::Vector3d& p_WC = pair.manifold.contacts[k].p_WC;
      const Velocities u = VelocitiesAt(pair, p_WC, bodies, free_);
      const Eigen::Vector3d with_restitution =
          RelativeVelocity(pair, p_WC, bodies, elastic_velocities_);
      island.inelastic += AddedEnergy(pair.J_W[k], u);
      island.inelastic_work += pair.J_W[k].dot(u.after - u.with_loads) / 2;
      island.curvature +=
          (pair.J_W[k] - elastic_[p].J_W[k]).dot(u.after - with_restitution) / 2;
    }
  }
  const auto blend = [](double s, const Eigen::Vector3d& elastic,
                        const Eigen::Vector3d& inelastic) -> Eigen::Vector3d {
    return (1 - s) * elastic + s * inelastic;
  };
  for (const ColouredPair& at : solved) {
    const auto p = static_cast<std::size_t>(at.pair);
    const Island& island = islands_[IslandOf(pairs[p], bodies, island_roots)];
    const double s = island.Fraction();
    for (std::size_t k = 0; k < pairs[p].manifold.points().size(); ++k)
      pairs[p].J_W[k] = island.Scale() * blend(s, elastic_[p].J_W[k], pairs[p].J_W[k]);
  }
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const Island& island = islands_[static_cast<std::size_t>(island_roots[i])];
    const double s = island.Fraction();
    const double scale = island.Scale();
    Velocity& velocity = bodies.velocities[i];
    velocity.v = blend(s, elastic_velocities_[i].v, velocity.v);
    velocity.w = blend(s, elastic_velocities_[i].w, velocity.w);
    if (scale == 1) continue;
    velocity.v = free_[i].v + scale * (velocity.v - free_[i].v);
    velocity.w = free_[i].w + scale * (velocity.w - free_[i].w);
  }
}

}  // namespace cookbook
