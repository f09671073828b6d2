#include "engine/dynamics/impacts/impact.h"

#include <algorithm>
#include <cmath>

namespace cookbook {
namespace {

/** Energy that counts as rounding, as a fraction of the work at the approach. */
constexpr double kRounding = 1e-13;

}  // namespace

Impact::Impact() {
  // Enough for most impacts, which then allocate nothing.
  constexpr std::size_t kMany = 64;
  members_.reserve(kMany);
  bodies_.reserve(kMany);
  inertias_.reserve(kMany);
  before_.reserve(kMany);
  after_.reserve(kMany);
  contact_flags_.reserve(kMany);
  static_.reserve(kMany);
  pairs_.reserve(kMany);
  summaries_.reserve(kMany);
}

void Impact::BeginStep(std::size_t bodies) {
  local_index_.resize(bodies, -1);
  work_spent_ = 0;
}

void Impact::AddBody(int body, const RigidBody& now) {
  local_index_[static_cast<std::size_t>(body)] = static_cast<int>(members_.size());
  members_.push_back(body);
  bodies_.push_back(now);
  inertias_.push_back(InverseInertiaOf(now));
  before_.push_back({now.state.v_WB, now.state.w_WB});
  static_.push_back(now.is_static() ? 1 : 0);
}

void Impact::AddContacts(const ContactPair& pair) {
  ContactPair& added = pairs_.emplace_back(pair);
  added.A = local_index_[static_cast<std::size_t>(pair.A)];
  added.B = local_index_[static_cast<std::size_t>(pair.B)];
  added.J_W.fill(Eigen::Vector3d::Zero());
  for (ContactPoint& contact : added.manifold.contacts) contact.separation = 0;
  summaries_.push_back({added.A, added.B, added.manifold.count});
}

void Impact::Solve(const StepContext& step, std::vector<ContactPair>& impact_contacts) {
  before_.emplace_back();
  contact_flags_.assign(members_.size(), ContactFlags{});
  SolveOnce(step);
  ReduceRestitution(step);
  for (const ContactPair& pair : pairs_) {
    const auto points = pair.manifold.points().size();
    const bool has_impulse =
        std::any_of(pair.J_W.begin(), pair.J_W.begin() + points,
                    [](const Eigen::Vector3d& J) { return !J.isZero(0); });
    if (!has_impulse) continue;
    ContactPair& appended = impact_contacts.emplace_back(pair);
    appended.A = members_[static_cast<std::size_t>(pair.A)];
    appended.B = members_[static_cast<std::size_t>(pair.B)];
  }
}

void Impact::SolveOnce(const StepContext& step) {
  const Settings& settings = step.settings;
  after_.assign(before_.begin(), before_.end());
  solver_.Begin(pairs_, summaries_, {bodies_, inertias_, before_, after_, static_}, step);
  for (int k = 0;
       k < settings.impulse_iterations || work_spent_ <= settings.iteration_budget; ++k) {
    work_spent_ += solver_.constraint_count();
    if (solver_.Iterate(after_, step.pool) <= settings.residual * solver_.max_speed())
      break;
  }
  solver_.StoreImpulses(pairs_, step, contact_flags_);
}

double Impact::WorkAt(std::span<const ContactPair> impulses,
                      std::span<const Velocity> velocities) const {
  double work = 0;
  for (const ContactPair& pair : impulses) {
    const auto velocity_at = [&](int body,
                                 const Eigen::Vector3d& p_W) -> Eigen::Vector3d {
      const auto i = static_cast<std::size_t>(body);
      return velocities[i].v + velocities[i].w.cross(p_W - bodies_[i].state.p_WB);
    };
    for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
      const Eigen::Vector3d& p_WC = pair.manifold.contacts[k].p_WC;
      work += pair.J_W[k].dot(velocity_at(pair.B, p_WC) - velocity_at(pair.A, p_WC));
    }
  }
  return work;
}

void Impact::ReduceRestitution(const StepContext& step) {
  // The energy that the impulses add; negative if they take energy.
  const auto gain = [&] {
    return (WorkAt(pairs_, before_) + WorkAt(pairs_, after_)) / 2;
  };
  const double gain_elastic = gain();
  if (gain_elastic <= kRounding * std::abs(WorkAt(pairs_, before_))) return;

  elastic_pairs_ = pairs_;
  elastic_after_ = after_;
  for (RigidBody& body : bodies_) body.restitution = 0;
  SolveOnce(step);

  // E(s) of the impulses (1 − s) J + s J₀ is E + b s + c s², and convex.
  const double gain_inelastic = gain();
  const double c =
      (WorkAt(pairs_, after_) - WorkAt(pairs_, elastic_after_) -
       WorkAt(elastic_pairs_, after_) + WorkAt(elastic_pairs_, elastic_after_)) /
      2;
  const double b = gain_inelastic - gain_elastic - c;
  const double root = std::sqrt(std::max(0.0, b * b - 4 * c * gain_elastic));
  const double s = std::clamp(2 * gain_elastic / (root - b), 0.0, 1.0);
  const auto blend = [s](const auto& elastic, const auto& inelastic) {
    return ((1 - s) * elastic + s * inelastic).eval();
  };
  for (std::size_t i = 0; i < after_.size(); ++i) {
    after_[i].v = blend(elastic_after_[i].v, after_[i].v);
    after_[i].w = blend(elastic_after_[i].w, after_[i].w);
  }
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    for (std::size_t k = 0; k < pairs_[p].manifold.points().size(); ++k)
      pairs_[p].J_W[k] = blend(elastic_pairs_[p].J_W[k], pairs_[p].J_W[k]);
  }
}

void Impact::Clear() {
  for (const int body : members_) local_index_[static_cast<std::size_t>(body)] = -1;
  members_.clear();
  bodies_.clear();
  inertias_.clear();
  before_.clear();
  static_.clear();
  pairs_.clear();
  summaries_.clear();
}

}  // namespace cookbook
