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

double RestitutionLimit::Island::Fraction() const {
  if (elastic <= rounding) return 0;
  const double slope = inelastic - elastic - curvature;
  const double root = std::sqrt(std::max(0.0, slope * slope - 4 * curvature * elastic));
  return root > slope ? std::min(1.0, 2 * elastic / (root - slope)) : 1;
}

bool RestitutionLimit::Exceeds(std::span<const ContactPair> pairs,
                               const SolverBodies& bodies, std::span<const Velocity> free,
                               std::span<const int> island_roots) {
  islands_.assign(bodies.rigid_bodies.size(), {});
  bool exceeds = false;
  for (const ContactPair& pair : pairs) {
    if (pair.manifold.count == 0) continue;
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

void RestitutionLimit::Blend(std::span<ContactPair> pairs, const SolverBodies& bodies,
                             std::span<const int> island_roots) {
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const ContactPair& pair = pairs[p];
    if (pair.manifold.count == 0) continue;
    Island& island = islands_[IslandOf(pair, bodies, island_roots)];
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
      const Eigen::Vector3d& p_WC = pair.manifold.contacts[k].p_WC;
      const Velocities u = VelocitiesAt(pair, p_WC, bodies, free_);
      const Eigen::Vector3d with_restitution =
          RelativeVelocity(pair, p_WC, bodies, elastic_velocities_);
      island.inelastic += AddedEnergy(pair.J_W[k], u);
      island.curvature +=
          (pair.J_W[k] - elastic_[p].J_W[k]).dot(u.after - with_restitution) / 2;
    }
  }
  const auto blend = [](double s, const Eigen::Vector3d& elastic,
                        const Eigen::Vector3d& inelastic) -> Eigen::Vector3d {
    return (1 - s) * elastic + s * inelastic;
  };
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (pairs[p].manifold.count == 0) continue;
    const double s = islands_[IslandOf(pairs[p], bodies, island_roots)].Fraction();
    for (std::size_t k = 0; k < pairs[p].manifold.points().size(); ++k)
      pairs[p].J_W[k] = blend(s, elastic_[p].J_W[k], pairs[p].J_W[k]);
  }
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const double s = islands_[static_cast<std::size_t>(island_roots[i])].Fraction();
    Velocity& velocity = bodies.velocities[i];
    velocity.v = blend(s, elastic_velocities_[i].v, velocity.v);
    velocity.w = blend(s, elastic_velocities_[i].w, velocity.w);
  }
}

}  // namespace cookbook
