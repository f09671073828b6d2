#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/solver/constraint_group.h"
#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/dynamics/solver/iteration_budget.h"
#include "engine/dynamics/solver/static_equilibrium.h"
#include "engine/dynamics/solver/step_context.h"
#include "engine/dynamics/solver/union_find.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** Returns whether single precision will do for a body. What a contact resists with,
 1/m + a·I⁻¹ a with |a| <= r, is off by a few 6e-8 of what its greatest terms are: where
 they cancel, as across a wire, by many times itself. Here by 1e-3 of itself at most. Of
 such masses, and no speed beyond 1e12 m/s, the square of an impulse is a float. */
bool FitsSinglePrecision(const RigidBody& body);

/** Sequential impulses: finds by sweeps the impulses that leave no contact approaching.

 With u the velocity of B against A at a contact, n the normal, h the step, u₀ and u_f
 the velocities before the step and at its end without impulses:

   u·n >= max(0, −e u₀·n + (u_f − u₀)·n)   where u₀·n < −(resting speed),
   u·n >= −e u₀·n + (u_f − u₀)·n           where e u₀·n > (resting speed),
   u·n >= min(0, −e u₀·n)                  elsewhere, or −gap / h where that is less,

 with an impulse λ >= 0 that is zero where the inequality is strict. The first line sends
 back the velocity of the start of the step and then lets the forces of the step act, so
 that a bounce at e = 1 keeps the energy whatever the step. The second and third let what
 a impact turns round in the step that it leaves in come back no faster than it left
 (Moreau's rule, under which impacts of one e together, without friction, never gain
 energy: with u = −e u₀ where λ > 0 and W the response, ½ λ·(u + u₀) =
 −½ (1 − e)/(1 + e) λ·W λ; friction at an eccentric contact may add to it). Friction:
 |λ_t| <= μ λ in the circular cone; λ_t is against the slip where it is at the bound, and
 there is no slip where it is inside.

 Four pairs that share no moving body are solved at once, sixteen in single precision.
 What contacts join is a island, and islands do not depend on each other: a large world is
 solved group after group of them, each small enough to stay in a processor's cache from
 its first sweep to its last. */
class ContactSolver {
 public:
  /** `threads`: how many solve at once. */
  explicit ContactSolver(int threads);

  /** Finds the impulses; writes them to the pairs, and what they did to the bodies.
   `edges` are those of the pairs. */
  void Solve(std::span<ContactPair> pairs, std::span<const ContactEdge> edges,
             const SolverBodies& world, const StepContext& step,
             std::span<Touch> touches);

  // The same in parts, for a world in which something else is solved with the contacts.

  /** Sets up the rows of all pairs with contacts and applies the impulses to start from.
   */
  void Begin(std::span<const ContactPair> pairs, std::span<const ContactEdge> edges,
             const SolverBodies& world, const StepContext& step);
  /** Sweeps once over all contacts and returns the greatest change of a relative
   velocity. [m/s] */
  double Iterate(std::span<Velocity> velocities, ThreadPool& pool);
  /** Writes what Solve() does; may be called again after further sweeps. */
  void StoreImpulses(std::span<ContactPair> pairs, const StepContext& step,
                     std::span<Touch> touches);
  /** The greatest speed that a contact sees before it is solved. [m/s] */
  double scale() const { return whole_.scale(); }
  int constraint_count() const { return whole_.constraint_count(); }
  /** Whether the world solved last was large, see IsSmall(). It stays so until it has
   half as many contacts: what is kept of them hangs on it. */
  bool is_large() const { return is_large_; }

  /** Fills `moves` with what removes overlap of the pairs solved last, see
   * FindPositionCorrections().
   */
  bool FindPositionCorrections(const StepMotion& motion, const StepContext& step,
                               std::span<Velocity> corrections);

 private:
  /** Some islands: a part of ordered_. */
  struct Part {
    std::size_t begin = 0;
    std::size_t end = 0;
    int contacts = 0;
  };

  /** What solves parts of a large world. */
  template <class Real>
  struct Groups {
    ConstraintGroup<Real> shared;            ///< Of a part that all threads share.
    std::vector<ConstraintGroup<Real>> own;  ///< Of each thread.
    /** What is too deep to be left: for each thread its own, and last what all share. No
     two of them have a moving body in common. */
    std::vector<Overlaps<Real>> overlaps;

    explicit Groups(std::size_t threads) : own(threads), overlaps(threads + 1) {}
  };

  /** What all solving is given. */
  struct Problem {
    std::span<ContactPair> pairs;
    const SolverBodies& world;
    const StepContext& step;
    std::span<Touch> touches;
  };

  /** Begin() after BuildConstraintGraph(). */
  void BeginWhole(std::span<const ContactPair> pairs, const SolverBodies& world,
                  const StepContext& step);
  /** Sweeps until the whole is solved, or no iteration_budget is left; what sweeps do not
   solve soon is brought to rest where that can be, see StaticEquilibrium. */
  void IterateUntilConverged(const SolverBodies& world, const StepContext& step);
  /** Sweeps part after part a few times, each with the velocities given. */
  template <class Real>
  void SolveLarge(const Problem& problem, std::span<SolverVelocity<Real>> velocities,
                  Groups<Real>& groups);

  void ForgetOverlaps();
  /** Gives each pair with contacts its colour, and joins bodies to islands. */
  void BuildConstraintGraph(std::span<const ContactEdge> edges,
                            std::span<const char> is_static, const Settings& settings);
  /** Divides the islands into parts of at least `least` contacts where there are so many.
   */
  void Divide(std::span<const char> is_static, int least);
  /** Sorts the pairs by part, colour and number of contacts. */
  void Order();

  std::vector<std::uint64_t> colours_;  ///< Of each body: one bit for each in use.
  int colours_used_ = 0;
  std::vector<ColouredPair> coloured_;  ///< The pairs with contacts, in their order.
  std::vector<int> part_;               ///< Of each of those.
  std::vector<int> by_key_;             ///< The same, by colour and number of contacts.
  std::vector<int> starts_;             ///< Where in `by_key_` each key starts.
  std::vector<ColouredPair> ordered_;   ///< The pairs, by part and then by key.
  std::vector<Part> parts_;
  int contacts_ = 0;
  UnionFind islands_;            ///< Of bodies.
  std::span<const int> island_;  ///< Of each body the one that stands for its island.
  std::vector<int> heap_part_;   ///< Of each body that stands for a island.
  std::vector<double>
      heap_changes_;  ///< Room for ConstraintGroup::FreezeConvergedIslands().
  ConstraintGroup<double> whole_;  ///< Of a small world.
  StaticEquilibrium standstill_;
  Groups<double> groups_;  ///< Of a large one, and the overlaps of both.
  Groups<float> single_groups_;
  bool is_large_ = false;
  bool is_single_ = false;              ///< Whether those were used last.
  std::vector<SingleVelocity> single_;  ///< Changes of velocities, or moves.
  IterationBudget iteration_budget_;
  ThreadPool alone_{1};
};

}  // namespace cookbook
