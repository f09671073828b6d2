#include "engine/dynamics/world/contact_work_limit.h"

#include <algorithm>

namespace cookbook {
namespace {

/** Error of a mean velocity: by the rounding of velocities, as a fraction of them, and by
 that of an orientation. [-], [rad] */
constexpr double kVelocityRounding = 1e-13;
constexpr double kRotationRounding = 1e-15;

/** Number of factors that the secant method tries before the factor is 0. */
constexpr int kMaxFactors = 8;

}  // namespace

void ContactWorkLimit::Begin(std::span<const ContactPair> pairs,
                             const LinkedIslands& islands, std::size_t bodies) {
  pairs_ = pairs;
  linked_pairs_.clear();
  islands_.assign(bodies, {});
  const std::span<const PairSummary> summaries = islands.linked_pairs();
  for (std::size_t p = 0; p < summaries.size(); ++p) {
    if (summaries[p].count > 0)
      linked_pairs_.push_back({p, islands.IslandOf(summaries[p])});
  }
}

void ContactWorkLimit::ChangeFactor(Island& island) {
  const double slope = island.work / island.factor;
  double factor = island.factor / 2;
  if (island.judged > 0 && slope != island.last_slope) {
    factor = island.factor -
             slope * (island.factor - island.last_factor) / (slope - island.last_slope);
  }
  if (++island.judged >= kMaxFactors || !(factor > 0)) factor = 0;
  island.last_factor = island.factor;
  island.last_slope = slope;
  island.factor = std::min(1.0, factor);
}

bool ContactWorkLimit::Exceeds(const Step& step) {
  for (Island& island : islands_) island.work = island.rounding = 0;
  for (const LinkedPair& linked : linked_pairs_) {
    const ContactPair& pair = pairs_[linked.index];
    Island& island = islands_[linked.island];
    const auto a = static_cast<std::size_t>(pair.A);
    const auto b = static_cast<std::size_t>(pair.B);
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
      const Eigen::Vector3d J_W = island.factor * pair.J_W[k];
      if (J_W.isZero(0)) continue;
      double rounding = 0;
      const auto mean_of = [&](std::size_t body) -> Eigen::Vector3d {
        const Velocity& mean = step.mean[body];
        const Velocity& before = step.before[body];
        const Eigen::Vector3d r =
            pair.manifold.contacts[k].p_WC - step.bodies[body].state.p_WB;
        if (!step.bodies[body].is_static()) {
          rounding += kVelocityRounding * (mean.v.norm() + before.v.norm() +
                                           r.norm() * (mean.w.norm() + before.w.norm())) +
                      kRotationRounding * r.norm() / step.h;
        }
        return mean.At(r);
      };
      const Eigen::Vector3d u = mean_of(b) - mean_of(a);
      island.work += J_W.dot(u);
      island.rounding += J_W.norm() * rounding;
    }
  }
  bool exceeds = false;
  for (Island& island : islands_) {
    if (island.factor == 0) continue;
    // The second factor only tells the slope, unless it is the first one again.
    const bool is_right = island.work <= island.rounding && island.judged != 1;
    if (is_right) continue;
    exceeds = true;
    ChangeFactor(island);
  }
  return exceeds;
}

void ContactWorkLimit::AddImpulses(std::span<const RigidBody> bodies,
                                   std::span<const InverseInertia> inertias,
                                   std::span<Velocity> velocities) const {
  for (const LinkedPair& linked : linked_pairs_) {
    const ContactPair& pair = pairs_[linked.index];
    const double factor = islands_[linked.island].factor;
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
      const auto apply = [&](int body, double sign) {
        const auto i = static_cast<std::size_t>(body);
        if (bodies[i].is_static()) return;
        const Eigen::Vector3d J_W = sign * factor * pair.J_W[k];
        const Eigen::Vector3d r = pair.manifold.contacts[k].p_WC - bodies[i].state.p_WB;
        velocities[i].v += inertias[i].mass * J_W;
        velocities[i].w += inertias[i].Times(r.cross(J_W));
      };
      apply(pair.A, -1);
      apply(pair.B, 1);
    }
  }
}

void ContactWorkLimit::Scale(std::span<ContactPair> pairs) const {
  for (const LinkedPair& linked : linked_pairs_) {
    for (Eigen::Vector3d& J_W : pairs[linked.index].J_W)
      J_W *= islands_[linked.island].factor;
  }
}

}  // namespace cookbook
