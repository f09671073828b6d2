#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/contacts/contact_cache.h"
#include "engine/dynamics/impacts/impact.h"
#include "engine/dynamics/impacts/impact_queue.h"
#include "engine/dynamics/impacts/time_of_impact.h"
#include "engine/dynamics/solver/step_context.h"
#include "engine/dynamics/solver/union_find.h"
#include "engine/threads/per_chunk.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** Continuous collision: resolves the impacts of a step in the order of their time of
 impact.

 A body is in free flight for a step if no joint or spring is attached to it, each of its
 contacts is either separating or an impact, and every body that it touches other than by
 an impact is in free flight too. Bodies in free flight are followed until their first
 impact. There they exchange the impulses of ContactSolver with everything that touches
 them at that time, and continue. So a bounce takes no time, and positions are as exact as
 energies.

 The other dynamic bodies are constrained: they move as contacts, joints and springs
 allow. If one of them is hit, its whole island takes part in the impact. The body is
 followed backwards from the end of the step, at the acceleration that led it there: none
 if it has landed, whose contacts have acted at the start of the step; that of gravity
 along a slope on which it slides. So an impact takes energy from the state that it
 changes. If no contact of the island bears a load in the step, the body was in free
 flight all the time.

 Some impacts are left to the next step, which finds the bodies in penetration:
  - on an island that has more than 32 bodies, a joint or a spring;
  - of a body in free flight after its 256th impact in the step, where it waits; others
    may pass into it;
  - between two constrained bodies;
  - between a body sped up by an impact and a sleeping body it could not otherwise reach.
 Thin bodies may tunnel there. */
class ImpactSolver {
 public:
  ImpactSolver();

  /** The bodies at the start of a step. */
  struct StepStart {
    std::span<const RigidBody> bodies;
    std::span<const Velocity> before;  ///< At the start of the step.
    std::span<const Velocity> free;    ///< At the end of the step, without impulses.
    const std::vector<bool>& asleep;
    const std::vector<bool>& linked;
  };

  /** Begins a step: finds the bodies in free flight and the candidates for
   impacts. Releases the contacts of bodies in free flight from `cache`. */
  void Begin(const StepStart& start, ContactCache& cache, const StepContext& step);

  /** Resolves the impacts. `bodies` are those after the step; bodies with an impact are
   moved to where it leads them. `mean` are the velocities that moved the constrained
   bodies during the step. */
  void Solve(std::span<RigidBody> bodies, std::span<const Velocity> mean,
             ContactCache& cache, const StepContext& step);

  /** Removes the impacts of the last step. */
  void Clear();

  /** The pairs of bodies in free flight that were deeper in each other than their slop at
   the start of the last step, and had an impact with each other in it. Begin() has
   released their contacts. */
  std::span<const std::pair<int, int>> deep_hit_pairs() const { return deep_pairs_; }

  /** Contacts of the impacts of the last step, each at its time of impact. */
  std::span<const ContactPair> impact_contacts() const { return impact_contacts_; }

 private:
  /** The force between a static body and a body that rests on it after an impact. */
  struct Support {
    int body;                   ///< The body that rests.
    std::size_t pair;           ///< Index into impact_contacts().
    Eigen::Vector3d force_B_W;  ///< Force on B of the pair. [N]
    double from;                ///< [s]
    double until;               ///< [s]
  };

  /** The bodies after the step. */
  struct StepEnd {
    std::span<const RigidBody> bodies;
    std::span<const Velocity> mean;
    std::span<const ContactPair> pairs;
    std::span<const PairSummary> summaries;
  };

  /** A pair with contacts at the start of the step. */
  struct TouchingPair {
    int A;
    int B;
    /** kImpacting if all contacts are; kResting if one is, or penetrates and is not an
     impact; otherwise kSeparating. */
    ContactPhase phase;
  };

  /** Two bodies that are close to each other. */
  struct NearPair {
    int A;
    int B;
    double gap;  ///< See ImpactCandidate. [m]
  };

  bool IsInFreeFlight(int body) const {
    return in_free_flight_[static_cast<std::size_t>(body)] != 0;
  }
  bool IsStatic(int body) const { return static_[static_cast<std::size_t>(body)] != 0; }
  /** Whether a body is dynamic and not in free flight. */
  bool IsConstrained(int body) const { return !IsInFreeFlight(body) && !IsStatic(body); }

  /** Leaves those pairs in deep_pairs_ that had an impact. */
  void KeepDeepPairsThatHit();
  /** Finds the bodies in free flight and releases their pairs. Returns whether there are
   any. */
  bool FindFreeBodies(const StepStart& start, ContactCache& cache, ThreadPool& pool);
  /** Fills touching_pairs_, one for each pair of `cache`. Constrains the bodies of pairs
   that rest. */
  void ClassifyContacts(const ContactCache& cache, std::span<const RigidBody> bodies,
                        ThreadPool& pool);
  /** Returns TouchingPair::phase. */
  ContactPhase PhaseOf(const ContactPair& pair, std::span<const RigidBody> bodies,
                       const ImpactRules& rules) const;
  /** Joins a body to the island that it hits if the two are too large for an impact. The
   body then is constrained if the island is. */
  void ConstrainBodiesHittingLargeIslands();
  /** Finds the candidates for impacts and begins the flights of their bodies. */
  void FindCandidates(const StepStart& start, const ContactCache& cache,
                      ThreadPool& pool);
  /** Begins the flight of a body at the start of the step. */
  void BeginFlight(int body, const StepStart& start);
  /** Fills island_root_ and island_size_ for the constrained bodies. */
  void FindIslands();
  void CountIslandBodies();
  /** Returns the number of bodies in the island of a constrained body, 0 for other
   bodies. A body with a joint or a spring counts as more than kMaxIslandSize. */
  int IslandSizeOf(int body) const {
    if (!IsConstrained(body)) return 0;
    const int root = island_root_[static_cast<std::size_t>(body)];
    return island_size_[static_cast<std::size_t>(root)];
  }
  /** Fills the lists of the contacts of each island. */
  void BuildContactLists(std::span<const PairSummary> summaries);
  /** Calls `visit(pair)` for each contact pair of the island of a constrained body. */
  template <class Visit>
  void ForEachContactOfIsland(int body, const StepEnd& end, const Visit& visit);
  /** Whether an impact of the candidate is resolved in this step. */
  bool IsEligible(const ImpactCandidate& candidate) const;
  /** Returns the next time of impact from `from` on; infinite: none. [s] */
  double NextTimeOfImpact(double from, const ImpactCandidate& candidate) const;
  void Schedule(double from, int candidate);
  /** Schedules the first impact of each candidate. */
  void ScheduleAll(ThreadPool& pool);
  /** Whether the two bodies can get close enough to collide, with their motion at the
   start of the step. */
  bool MayCollide(const ImpactCandidate& candidate) const;
  /** Resolves the impact of `first`, with everything that touches it at that time. */
  void ResolveImpact(const ImpactCandidate& first, const StepEnd& end,
                     const StepContext& step);
  /** Adds all contacts of the bodies of the current impact at time `t`, and with them the
   other bodies. */
  void GatherContacts(double t, const StepEnd& end);
  /** Returns whether a contact of the island of a constrained body has an impulse. */
  bool BearsLoad(int body, const StepEnd& end);
  /** Adds the bodies and contacts of the island of a constrained body. */
  void AddIsland(int body, double t, const StepEnd& end);
  /** Begins the flight of a body without an impact so far: backwards from its state after
   the step. */
  void BeginFlightFromEnd(int body, const StepEnd& end);
  /** Adds candidates for a body that leaves an impact at `t` faster than it came. */
  void AddNewCandidates(int body, double t, const StepEnd& end, ContactCache& cache);
  /** Adds a body to the current impact, at time `t`, unless it is part of it already. */
  void AddBody(int body, double t);
  /** Begins the flights of the bodies of the current impact, with their new velocities.
   */
  void ResumeFlights(double t);
  /** Adds a support for each body in free flight that rests on a static body since the
   current impact, whose contacts start at index `first`. A support cancels the
   acceleration of the body towards the static one. */
  void AddSupports(std::size_t first, double t);
  /** Adds the impulses of the supports to those of the contacts. */
  void ApplySupportImpulses();

  ImpactRules rules_;
  // Flags are 0 or 1. They are bytes because threads write them at the same time, some
  // through std::atomic_ref; neighbouring bits of a vector<bool> would race.
  std::vector<char> in_free_flight_;  ///< Indexed by body.
  std::vector<char> static_;          ///< Indexed by body.
  std::vector<char> asleep_;          ///< Indexed by body.
  std::vector<char> linked_;          ///< Indexed by body: has a joint or a spring.
  std::vector<int> impact_count_;     ///< Indexed by body: number of impacts so far.
  std::vector<FreeFlight> flights_;   ///< Indexed by body: motion since its last impact.
  std::vector<char> has_flight_;      ///< Indexed by body: flight is of this step.
  std::vector<double> max_travel_;    ///< Indexed by body: bound for this step. [m]
  /** Indexed by body: acceleration due to gravity and forces alone. [m/s²] */
  std::vector<Eigen::Vector3d> accelerations_;
  std::vector<Support> supports_;
  ImpactQueue queue_;
  std::vector<int> neighbours_;  ///< New neighbours of one body.
  std::vector<ContactPair> impact_contacts_;
  std::vector<std::pair<int, int>> deep_pairs_;  ///< See deep_hit_pairs().
  std::vector<TouchingPair> touching_pairs_;
  PerChunk<NearPair> near_pairs_;
  std::vector<int> flights_to_begin_;  ///< Indices of bodies.
  std::vector<double> first_impacts_;  ///< Indexed by candidate: first impact. [s]
  UnionFind islands_;                  ///< Bodies that touch other than by an impact.
  std::span<const int> island_root_;   ///< Indexed by body: root of its island.
  UnionFind impact_islands_;           ///< Like islands_, but joined by impacts too.
  std::vector<std::pair<int, int>> impacting_pairs_;
  std::vector<char> is_constrained_island_;  ///< Indexed by root: 1 if any body is.
  std::vector<int> island_size_;             ///< Indexed by root: number of bodies.
  // The contact pairs of each island of constrained bodies, as linked lists.
  std::vector<int> first_contact_of_island_;  ///< Indexed by root; −1: none.
  std::vector<int> next_contact_;  ///< Indexed by contact pair; −1: the last.
  bool has_contact_lists_ = false;

  Impact impact_;  ///< The current impact.
  // Binary heaps with the least on top: candidates to test for the current impact, in
  // this pass and in the next.
  std::vector<int> pending_;
  std::vector<int> deferred_;
};

}  // namespace cookbook
