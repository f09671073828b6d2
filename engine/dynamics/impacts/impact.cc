#include "engine/dynamics/impacts/impact.h"

#include <algorithm>

namespace cookbook {

Impact::Impact() {
  // Of most impacts of most steps: from then on they allocate nothing.
  constexpr std::size_t kMany = 64;
  members_.reserve(kMany);
  bodies_.reserve(kMany);
  inertias_.reserve(kMany);
  before_.reserve(kMany);
  after_.reserve(kMany);
  touches_.reserve(kMany);
  static_.reserve(kMany);
  pairs_.reserve(kMany);
  edges_.reserve(kMany);
}

void Impact::BeginStep(std::size_t bodies) {
  place_.resize(bodies, -1);
  spent_ = 0;
}

void Impact::Add(int body, const RigidBody& now) {
  place_[static_cast<std::size_t>(body)] = static_cast<int>(members_.size());
  members_.push_back(body);
  bodies_.push_back(now);
  inertias_.push_back(InverseInertiaOf(now));
  before_.push_back({now.state.v_WB, now.state.w_WB});
  static_.push_back(now.is_static() ? 1 : 0);
}

void Impact::Add(const ContactPair& pair) {
  ContactPair& added = pairs_.emplace_back(pair);
  added.A = place_[static_cast<std::size_t>(pair.A)];
  added.B = place_[static_cast<std::size_t>(pair.B)];
  added.J_W.fill(Eigen::Vector3d::Zero());
  for (ContactPoint& contact : added.manifold.contacts) contact.separation = 0;
  edges_.push_back({added.A, added.B, added.manifold.count});
}

void Impact::Exchange(const Settings& settings, double h, ThreadPool& pool,
                      std::vector<ContactPair>& struck) {
  before_.emplace_back();
  after_.assign(before_.begin(), before_.end());
  touches_.assign(members_.size(), Touch{});
  const StepContext step{settings, h, pool};
  solver_.Begin(pairs_, edges_, {bodies_, inertias_, before_, after_, static_}, step);
  for (int k = 0; k < settings.impulse_iterations || spent_ <= settings.iteration_budget;
       ++k) {
    spent_ += solver_.constraint_count();
    if (solver_.Iterate(after_, pool) <= settings.residual * solver_.scale()) break;
  }
  solver_.StoreImpulses(pairs_, step, touches_);
  for (const ContactPair& pair : pairs_) {
    const auto points = pair.manifold.points().size();
    const bool gave = std::any_of(pair.J_W.begin(), pair.J_W.begin() + points,
                                  [](const Eigen::Vector3d& J) { return !J.isZero(0); });
    if (!gave) continue;
    ContactPair& known = struck.emplace_back(pair);
    known.A = members_[static_cast<std::size_t>(pair.A)];
    known.B = members_[static_cast<std::size_t>(pair.B)];
  }
}

void Impact::Clear() {
  for (const int body : members_) place_[static_cast<std::size_t>(body)] = -1;
  members_.clear();
  bodies_.clear();
  inertias_.clear();
  before_.clear();
  static_.clear();
  pairs_.clear();
  edges_.clear();
}

}  // namespace cookbook
