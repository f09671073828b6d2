#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_solver.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** A impact: what takes part in it is a world of its own, in which no time goes by. Its
 bodies exchange the impulses of ContactSolver. */
class Impact {
 public:
  Impact();

  /** Begins a step of a world of so many bodies. All impacts of a step share the
   iteration_budget of one solve. */
  void BeginStep(std::size_t bodies);

  /** Adds a body of the world that does not take part yet, as it is at that moment. */
  void Add(int body, const RigidBody& now);

  /** Adds how two bodies touch that take part. */
  void Add(const ContactPair& pair);

  bool IsIn(int body) const { return place_[static_cast<std::size_t>(body)] >= 0; }

  /** Returns a body that takes part as it came. */
  const RigidBody& BodyOf(int body) const {
    return bodies_[static_cast<std::size_t>(place_[static_cast<std::size_t>(body)])];
  }

  /** The bodies that take part, in the order in which they were added. */
  std::span<const int> members() const { return members_; }

  /** Finds the impulses, and appends to `struck` the pairs that gave any. */
  void Exchange(const Settings& settings, double h, ThreadPool& pool,
                std::vector<ContactPair>& struck);

  // Of the member `k`, after the exchange.
  Velocity After(std::size_t k) const { return after_[k]; }
  Velocity Gain(std::size_t k) const {
    return {after_[k].v - before_[k].v, after_[k].w - before_[k].w};
  }
  /** The greatest speed at which a contact came. [m/s] */
  double scale() const { return solver_.scale(); }

  /** Lets all go that took part: the next impact begins. */
  void Clear();

 private:
  ContactSolver solver_{1};
  int spent_ = 0;           ///< Sweeps × rows, in this step.
  std::vector<int> place_;  ///< By body of the world: among the following, or −1.
  std::vector<int> members_;
  std::vector<RigidBody> bodies_;
  std::vector<InverseInertia> inertias_;
  std::vector<Velocity> before_;  ///< One more than bodies, see SolverBodies.
  std::vector<Velocity> after_;
  std::vector<Touch> touches_;
  std::vector<char> static_;        ///< 1 where a body is.
  std::vector<ContactPair> pairs_;  ///< Of places.
  std::vector<ContactEdge> edges_;  ///< Of the same.
};

}  // namespace cookbook
