#include "engine/dynamics/impacts/impact.h"

#include <algorithm>

namespace cookbook {
Impact::Impact() {
  // Most impacts need no more. The first ones allocate the memory of the iterations.
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

void Impact::BeginStep(std::size_t bodies, const Settings& settings) {
  local_index_.resize(bodies, -1);
  iteration_budget_.Spend(work_spent_ + work_spent_on_less_restitution_, settings, 0);
  allowed_work_ = iteration_budget_.Remaining(settings, 0);
  work_spent_ = 0;
  work_spent_on_less_restitution_ = 0;
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
  added.mean_load.fill(0);  // Rigid: an impact takes no time.
  for (ContactPoint& contact : added.manifold.contacts) contact.separation = 0;
  summaries_.push_back({added.A, added.B, added.manifold.count});
}

bool Impact::Iterate(const StepContext& step, long& work_spent) {
  const Settings& settings = step.settings;
  for (int k = 1;; ++k) {
    work_spent += solver_.constraint_count();
    if (solver_.Iterate(after_, step.pool) <= settings.residual * solver_.max_speed())
      return true;
    if (k >= settings.impulse_iterations && work_spent > allowed_work_) return false;
    solver_.Accelerate(after_);
  }
}

void Impact::Solve(const StepContext& step, std::vector<ContactPair>& impact_contacts) {
  before_.emplace_back();
  contact_flags_.assign(members_.size(), ContactFlags{});
  after_.assign(before_.begin(), before_.end());
  const SolverBodies bodies{bodies_, inertias_, before_, after_, static_};
  solver_.Begin(pairs_, summaries_, bodies, step);
  const bool has_converged = Iterate(step, work_spent_);
  const ContactSolver::Problem problem{pairs_, bodies, step, contact_flags_};
  if (solver_.Finish(problem, before_, has_converged)) {
    Iterate(step, work_spent_on_less_restitution_);
    solver_.FinishWithLessRestitution(problem, before_);
  }
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
