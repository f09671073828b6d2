#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/solver/constraint_group.h"
#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/dynamics/solver/iteration_acceleration.h"
#include "engine/dynamics/solver/iteration_budget.h"
#include "engine/dynamics/solver/restitution_limit.h"
#include "engine/dynamics/solver/static_equilibrium.h"
#include "engine/dynamics/solver/step_context.h"
#include "engine/dynamics/solver/union_find.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** Returns whether single precision is accurate enough for the contacts of a body. The
 rounding error of a response, 1/m + a·I⁻¹ a with |a| <= r, is a few float roundings
 (6e-8) of its greatest term. Where the terms cancel, as for a long thin body hit across
 its length, that can be many times the response; for the bodies accepted here it is at
 most 1e-3 of it. With their masses, and speeds below
 1e12 m/s, the square of an impulse does not overflow a float. */
bool FitsSinglePrecision(const RigidBody& body);

/** Projected Gauss-Seidel over contact constraints (sequential impulses): iterations find
 impulses under which no contact approaches faster than its target, with Coulomb friction.

 A contact has the normal n out of A into B, the relative velocity u of B against A, the
 impulses λ along n and λ_t across it, the restitution e and the coefficient of friction
 μ. The solver finds impulses with

   u·n >= target,  λ >= 0,  and λ = 0 where u·n > target;
   |λ_t| <= μ λ (circular cone),  no slip where |λ_t| < μ λ,  λ_t against the slip else.

 Let h be the step, u₀ the relative velocity before the step, and u_f that at its end
 without impulses. The target is

   max(0, −e u₀·n + (u_f − u₀)·n)   if u₀·n < −threshold: the contact bounces;
   −e u₀·n + (u_f − u₀)·n           if e u₀·n > threshold: it separates;
   min(0, −e u₀·n)                  else.

 An open contact is speculative: its target is −gap / h if that is less, and a contact
 that would bounce is off until it is closed. The restitution threshold is
 Settings::restitution_threshold_factor × (h LoadAccelerationOn() + |(u_f − u₀)·n|).
 Baumgarte stabilisation and soft contacts add a speed to the second and third targets of
 a contact that is deeper than its slop.

 This differs from the textbook (Catto, GDC 2006) as follows:
 - *Restitution.* A bounce reverses the velocity before the step, and then the loads of
   the step act. At e = 1 it conserves energy with any step. Usually the velocity after
   the loads is reversed.
 - *Simultaneous impacts.* If an impact reverses a contact that was separating, it
   approaches afterwards no faster than e times its speed of separation (Moreau's rule,
   targets two and three).
   Then impacts of equal e without friction never add energy: with u = −e u₀ where
   λ > 0, and W the response, the change of energy is
   ½ λ·(u + u₀) = −½ (1 − e)/(1 + e) λ·W λ. With friction an eccentric impact may add
   energy; the restitution of its island is then reduced, see RestitutionLimit.
 - *Friction.* The two tangential impulses are solved together, on the circular cone,
   from the slip after the normal impulse.
 - *Yield.* A contact whose load deviates from its mean yields, see
   Settings::contact_frequency.
 - *Warm starting.* The loads of a face are first redistributed, see PrepareContacts().
 - *Batches.* Graph colouring finds pairs that share no moving body: four of them are
   solved at once in double precision, sixteen in single precision.
 - *Iterations.* All contacts get the first few iterations, over-relaxed. More follow
   until convergence while the iteration budget lasts, see IterationBudget. Islands that
   have converged are frozen, which leaves the budget to the others. Islands that have
   not are solved directly if possible, see StaticEquilibrium.
 - *Precision.* Steps without a budget for more iterations use single precision where
   possible. The results differ by rounding.
 - *Groups* of islands, each small enough for a processor's cache, are solved one after
   the other, or by different threads. */
class ContactSolver {
 public:
  /** `threads`: number of threads of the pool that later steps use. */
  explicit ContactSolver(int threads);

  /** Finds the impulses; writes them to the pairs, and sets the flags of the bodies.
   `summaries`: the summary of each pair. */
  void Solve(std::span<ContactPair> pairs, std::span<const PairSummary> summaries,
             const SolverBodies& bodies, const StepContext& step,
             std::span<ContactFlags> contact_flags);

  /** The arguments of Solve(). */
  struct Problem {
    std::span<ContactPair> pairs;
    const SolverBodies& bodies;
    const StepContext& step;
    std::span<ContactFlags> contact_flags;
  };

  // The parts of Solve(), for a caller that solves other constraints in the same
  // iterations (joints and springs) or has a budget of its own (impacts). The world is
  // solved as a whole, in double precision.

  /** Prepares the constraints of all pairs with contacts, and warm starts the velocities.
   `impacts_resolved`: whether the impacts of the step have been resolved before it. Then
   no contact bounces or yields, and bodies are taken to move by the mean of their
   velocities before and after the step: the target is min(0, −u₀·n), so that a normal
   impulse never does positive work. A speculative contact that approaches faster than the
   threshold is off. */
  void Begin(std::span<const ContactPair> pairs, std::span<const PairSummary> summaries,
             const SolverBodies& bodies, const StepContext& step,
             bool impacts_resolved = false);
  /** One iteration over all active contacts. Returns the greatest change of a relative
   velocity. [m/s] */
  double Iterate(std::span<Velocity> velocities, ThreadPool& pool);
  /** Moves the solution on between two iterations, see IterationAcceleration. */
  void Accelerate(std::span<Velocity> velocities) {
    acceleration_.Extrapolate(whole_world_.view(), velocities);
  }
  /** Writes the impulses to the pairs, and sets the flags of the bodies. May be called
   again after further iterations. */
  void StoreImpulses(std::span<ContactPair> pairs, const StepContext& step,
                     std::span<ContactFlags> contact_flags);
  /** Adds the effect of all impulses to `bodies.velocities`, in double precision. */
  void AddImpulses(const SolverBodies& bodies, ThreadPool& pool) {
    whole_world_.ApplyToBodies(bodies, pool);
  }
  /** Ends the iterations of a world without joints and springs. Stores the impulses, and
   the velocities `free` + their effect, which have less rounding error than the
   velocities of the iterations. `free`: with the loads and without impulses.

   Returns false if this is the solution. Returns true if it adds energy to an island,
   see RestitutionLimit. In this case the constraints are those without restitution, ready
   for Iterate(); iterate again, then call FinishWithLessRestitution(). `has_converged`:
   whether the iterations have found a solution. */
  [[nodiscard]] bool Finish(const Problem& problem, std::span<const Velocity> free,
                            bool has_converged);
  /** Ends the iterations without restitution. Stores the mean of this solution and the
   one with restitution that Finish() has kept, with the weights of RestitutionLimit. */
  void FinishWithLessRestitution(const Problem& problem, std::span<const Velocity> free);
  /** Greatest relative speed at a contact before it is solved. [m/s] */
  double max_speed() const { return whole_world_.max_speed(); }
  /** Number of active contacts. */
  int constraint_count() const { return whole_world_.constraint_count(); }

  /** Fills `corrections` with the displacements and rotations that remove penetration of
   the pairs solved last. Returns whether there is any to remove; otherwise `corrections`
   does not change. See the function FindPositionCorrections(). */
  bool FindPositionCorrections(const StepMotion& motion, const StepContext& step,
                               std::span<Velocity> corrections);

 private:
  /** Some islands that are solved together: a range of sorted_pairs_. */
  struct GroupRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    int contacts = 0;
  };

  /** The constraint groups of Solve(). */
  template <class Real>
  struct ThreadGroups {
    ConstraintGroup<Real> shared;            ///< Solved by all threads together.
    std::vector<ConstraintGroup<Real>> own;  ///< Indexed by thread.
    /** One list for each thread, and last one that all share. No two lists have a moving
     body in common. */
    std::vector<PositionConstraints<Real>> position_constraints;

    explicit ThreadGroups(std::size_t threads)
        : own(threads), position_constraints(threads + 1) {}
  };

  /** Sums the velocities from the impulses, and stores the impulses. */
  void StoreSolution(const Problem& problem, std::span<const Velocity> free);
  /** Begin() after BuildConstraintGraph(). */
  void BeginWholeWorld(std::span<const ContactPair> pairs, const SolverBodies& bodies,
                       const StepContext& step, double restitution_factor,
                       bool impacts_resolved);
  /** Solves the groups one after the other or by different threads, and stores velocities
   and impulses. `restitution_factor`: see ContactParameters. `extra_work`: see
   IterateGroup(). Returns the part of it that was spent. */
  long SolveGroups(const Problem& problem, double restitution_factor, long extra_work);
  template <class Real>
  long SolveGroups(const Problem& problem, double restitution_factor, long extra_work,
                   std::span<SolverVelocity<Real>> velocities,
                   ThreadGroups<Real>& groups);
  /** Settings::impulse_iterations iterations. In double precision, islands that have not
   converged then are brought to rest directly if possible, and are iterated until they
   converge or `extra_work`, iterations × contacts, is spent. Returns the extra work that
   was spent. */
  template <class Real>
  long IterateGroup(ConstraintGroup<Real>& group, const Problem& problem,
                    const ContactParameters& parameters, long extra_work,
                    std::span<SolverVelocity<Real>> velocities, ThreadPool& pool);
  /** Whether the stored solution adds energy, see RestitutionLimit. If so, keeps it and
   resets the velocities to `free`. Only restitution does, and iterations that have not
   found a solution. Large worlds, which are never solved, count as solved. */
  bool AddsEnergy(const Problem& problem, std::span<const Velocity> free);
  /** Blends the stored solution, without restitution, with the one that was kept. */
  void BlendRestitution(const Problem& problem);

  void ClearPositionConstraints();
  /** Colours the pairs with contacts, and finds the islands. */
  void BuildConstraintGraph(std::span<const PairSummary> summaries,
                            std::span<const char> is_static);
  /** Divides the islands into groups of at least `min_contacts` contacts each; the last
   may have fewer. */
  void DivideIntoGroups(std::span<const char> is_static, int min_contacts);
  /** Sorts the pairs by group, colour and number of contacts. */
  void SortPairs();

  std::vector<std::uint64_t> body_colours_;  ///< One bit for each used; indexed by body.
  int colours_used_ = 0;
  std::vector<ColouredPair> coloured_pairs_;  ///< All pairs with contacts.
  std::vector<int> group_of_pair_;            ///< Indexed like coloured_pairs_.
  std::vector<int> pairs_by_key_;  ///< Indices of the same, by colour and contact count.
  std::vector<int> key_starts_;    ///< First element of each key in pairs_by_key_.
  std::vector<ColouredPair> sorted_pairs_;  ///< Sorted by group, then by key.
  std::vector<GroupRange> group_ranges_;
  int contact_count_ = 0;
  UnionFind islands_;                    ///< Islands as sets of bodies.
  std::span<const int> island_roots_;    ///< Indexed by body.
  std::vector<int> group_of_island_;     ///< Indexed by the root of the island.
  std::vector<double> island_changes_;   ///< Scratch, see FreezeConvergedIslands().
  ConstraintGroup<double> whole_world_;  ///< See Begin().
  IterationAcceleration acceleration_;   ///< Of the iterations of whole_world_.
  StaticEquilibrium static_equilibrium_;
  RestitutionLimit restitution_limit_;
  std::vector<Velocity> free_velocities_;   ///< With the loads and without impulses.
  bool has_converged_ = true;               ///< Of the groups that have extra work.
  std::vector<ContactFlags> bounce_flags_;  ///< Those with the whole restitution.
  /** Also holds the position constraints of whole_world_. */
  ThreadGroups<double> double_groups_;
  ThreadGroups<float> float_groups_;
  bool is_single_precision_ = false;  ///< Whether float_groups_ were used last.
  /** Changes of velocities by impulses, later position corrections. */
  std::vector<SingleVelocity> single_velocities_;
  std::vector<Velocity> double_velocities_;  ///< As the iterations change them.
  IterationBudget iteration_budget_;
  ThreadPool one_thread_{1};  ///< For a group that a single thread solves.
};

}  // namespace cookbook
