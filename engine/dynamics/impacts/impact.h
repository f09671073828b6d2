#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_solver.h"
#include "engine/dynamics/solver/iteration_budget.h"
#include "engine/dynamics/solver/step_context.h"

namespace cookbook {

/** An impact: the bodies that touch at one time of impact, and their contacts. A
 ContactSolver of its own finds the impulses. No time passes and no force acts. */
class Impact {
 public:
  Impact();

  /** Begins a step of a world of `bodies` bodies. All impacts of a step share one
   iteration budget, and a second one for solutions with less restitution. A step with a
   slow impact may overdraw it, see IterationBudget. */
  void BeginStep(std::size_t bodies, const Settings& settings);

  /** Adds body `body` of the world, in its state `now` at the time of impact.
   @pre !Contains(body) */
  void AddBody(int body, const RigidBody& now);

  /** Adds the contacts of two bodies of the impact. */
  void AddContacts(const ContactPair& pair);

  bool Contains(int body) const {
    return local_index_[static_cast<std::size_t>(body)] >= 0;
  }

  /** Returns a body of the impact as it was added. */
  const RigidBody& BodyBefore(int body) const {
    return bodies_[static_cast<std::size_t>(
        local_index_[static_cast<std::size_t>(body)])];
  }

  /** The bodies of the impact, in the order in which they were added. */
  std::span<const int> members() const { return members_; }

  /** Computes the impulses, and appends the pairs with nonzero impulses to
   `impact_contacts`. */
  void Solve(const StepContext& step, std::vector<ContactPair>& impact_contacts);

  /** Returns the velocity of the k-th member after Solve(). */
  Velocity VelocityAfter(std::size_t k) const { return after_[k]; }
  /** Greatest relative velocity of a contact before the impact. [m/s] */
  double max_approach_speed() const { return solver_.max_speed(); }

  /** Removes all bodies and contacts, for the next impact. */
  void Clear();

 private:
  /** Iterates until the impulses are found or the budget is spent; returns which.
   `work_spent`: iterations × constraints in this step so far. */
  bool Iterate(const StepContext& step, long& work_spent);

  ContactSolver solver_{1};
  // See Iterate().
  long work_spent_ = 0;
  long work_spent_on_less_restitution_ = 0;
  long allowed_work_ = 0;  ///< Of this step.
  IterationBudget iteration_budget_;
  /** Indexed by body of the world: its index here, or −1. */
  std::vector<int> local_index_;
  std::vector<int> members_;
  std::vector<RigidBody> bodies_;
  std::vector<InverseInertia> inertias_;
  std::vector<Velocity> before_;  ///< One more than bodies, see SolverBodies.
  std::vector<Velocity> after_;
  std::vector<ContactFlags> contact_flags_;
  std::vector<char> static_;            ///< 1: static.
  std::vector<ContactPair> pairs_;      ///< A and B are indices here, not in the world.
  std::vector<PairSummary> summaries_;  ///< Summaries of pairs_.
};

}  // namespace cookbook
