#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/contacts/contact_cache.h"
#include "engine/dynamics/impacts/impact.h"
#include "engine/dynamics/impacts/impact_queue.h"
#include "engine/dynamics/impacts/time_of_impact.h"
#include "engine/dynamics/solver/union_find.h"
#include "engine/threads/per_chunk.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** The impacts of a step, each at its moment.

 A body flies in a step where nothing holds it: no rod or spring, and no contact but such
 as part or strike, nor any of what it touches but strikes. Bodies that fly are followed
 until they strike something; there they exchange the impulses of ContactSolver, with all
 that touch them at that moment, and fly on. So a bounce takes no time, and what it keeps
 is kept in its place too.

 What does not fly moves as contacts, rods and springs let it. Where it is struck, all
 that it rests on and that rests on it takes part in the impact, and what that changes of
 its velocity acts from then on.

 Not seen before the next step, which finds what is then inside: what strikes a island of
 more than 32 bodies, or what a rod or a spring holds; the impacts of a body after its
 eighth in a step; those of two bodies that are both held; and what a struck body reaches
 that sleeps. Thinner things may be gone through there, and where TimeOfImpact() says so.
 In a large world what strikes a island of more than 4 is not seen either, unless it goes
 so far in a step that the next might not tell which way it came. */
class ImpactSolver {
 public:
  ImpactSolver();

  /** Everything about the bodies at the start of a step. */
  struct Start {
    std::span<const RigidBody> bodies;
    std::span<const Velocity> before;
    std::span<const Velocity> free;  ///< At the end of the step, without impulses.
    const std::vector<bool>& asleep;
    const std::vector<bool>& linked;
    bool is_large;  ///< In the step before, see ContactSolver.
  };

  /** Begins a step of `h` [s]: finds what flies and what it may meet. Takes the contacts
   of what flies out of those that `cache` has. */
  void Begin(const Start& start, ContactCache& cache, const Settings& settings, double h,
             ThreadPool& pool);

  /** Follows what flies. `bodies` are those after the step; what was struck is put where
   its impacts lead it. `mean` is what has moved those that do not fly. */
  void Follow(std::span<RigidBody> bodies, std::span<const Velocity> mean,
              ContactCache& cache, const Settings& settings, ThreadPool& pool);

  /** Forgets the last step. */
  void Clear();

  /** What struck what, as it was at that moment. */
  std::span<const ContactPair> struck() const { return struck_; }

 private:
  /** What a static body bears of one that rests on it after a impact. */
  struct Support {
    int body;
    std::size_t pair;           ///< Of struck().
    Eigen::Vector3d force_B_W;  ///< On B of the pair. [N]
    double from;                ///< [s]
    double until;               ///< [s]
  };

  /** Everything about the bodies after the step. */
  struct End {
    std::span<const RigidBody> bodies;
    std::span<const Velocity> mean;
    std::span<const ContactPair> contacts;
    std::span<const ContactEdge> edges;
  };

  /** What a pair with contacts does when the step begins. */
  struct Touching {
    int A;
    int B;
    /** It strikes where all its contacts do, and holds where one does or where what
     overlaps has to be parted. */
    ContactPhase meeting;
  };

  /** Two bodies that are near each other. */
  struct Near {
    int A;
    int B;
    double gap;  ///< As ImpactCandidate.
  };

  bool IsInFreeFlight(int body) const {
    return in_free_flight_[static_cast<std::size_t>(body)] != 0;
  }
  bool IsStatic(int body) const { return static_[static_cast<std::size_t>(body)] != 0; }
  /** Whether it moves and does not fly. */
  bool IsHeld(int body) const { return !IsInFreeFlight(body) && !IsStatic(body); }

  bool FindFreeBodies(const Start& start, ContactCache& cache, ThreadPool& pool);
  /** Fills touching_: of each of the contacts. */
  void FindTouching(const ContactCache& cache, std::span<const RigidBody> bodies,
                    ThreadPool& pool);
  ContactPhase PhaseOf(const ContactPair& pair, std::span<const RigidBody> bodies,
                       const ImpactRules& rules) const;
  /** Joins to a island what strikes it where its impact would not be asked for. */
  void HoldStrikersOfLargeIslands();
  void FindCandidates(const Start& start, const ContactCache& cache, ThreadPool& pool);
  /** Begins the flight of a body at the start of the step. */
  void BeginFlight(int body, const Start& start);
  /** Fills island_ and island_size_ of what is held. */
  void FindIslands();
  void MeasureIslands();
  /** Returns how many bodies are in the island of a body that is held, 0 of others. Of
   more than 32 no impact is looked at; what rods and springs hold counts for so many. */
  int IslandOf(int body) const {
    if (!IsHeld(body)) return 0;
    const int island = island_[static_cast<std::size_t>(body)];
    return island_size_[static_cast<std::size_t>(island)];
  }
  void ListIslands(std::span<const ContactEdge> contacts);
  /** Whether impacts of the two are looked at. */
  bool IsAsked(const ImpactCandidate& candidate) const;
  /** Returns when the two meet next from `from` on. [s] */
  double NextImpact(double from, const ImpactCandidate& candidate) const;
  void Schedule(double from, int candidate);
  /** Foresees all candidates that come near each other. */
  void ScheduleAll(ThreadPool& pool);
  /** Whether the two come near enough to meet, going as they do when the step begins. */
  bool ComeNear(const ImpactCandidate& candidate) const;
  void Strike(const ImpactCandidate& first, const End& end, const Settings& settings,
              ThreadPool& pool);
  /** Adds to the impact what touches any of its bodies at time `t`. */
  void Gather(double t, const End& end);
  void JoinIsland(int body, double t, const End& end);
  /** Begins the flight of a body that no impact has changed: back from where it led. */
  void TraceBack(int body, const End& end);
  /** Adds what a body may meet that leaves a impact at `t` faster than it came. */
  void Widen(int body, double t, const End& end, ContactCache& cache);
  /** Adds a body to the impact at hand, at time `t`, unless it takes part already. */
  void Join(int body, double t);
  /** Lets the bodies of the impact at hand fly on. */
  void LetFly(double t);
  /** Takes from what flies on the load against what it now rests on, which has been
   struck since `first` of struck(). */
  void SupportSince(std::size_t first, double t);
  /** Adds to the impulses what supports gave. */
  void EndSupports();

  ImpactRules rules_;
  // 1 where it is so: bytes, since each is asked many times a step.
  std::vector<char> in_free_flight_;    ///< By body.
  std::vector<char> static_;            ///< By body.
  std::vector<char> asleep_;            ///< By body.
  std::vector<char> linked_;            ///< By body.
  std::vector<int> impacts_;            ///< By body: how many it had.
  std::vector<FreeFlight> flights_;     ///< By body: since its last impact.
  std::vector<char> begun_;             ///< By body: whether its flight is of this step.
  std::vector<double> reaches_;         ///< By body. [m]
  std::vector<Eigen::Vector3d> loads_;  ///< By body: of nothing that holds it. [m/s²]
  std::vector<Support> supports_;
  std::vector<Velocity> gains_;  ///< By body that is held: what impacts gave it.
  ImpactQueue queue_;
  std::vector<int> met_;  ///< What one body may meet.
  std::vector<ContactPair> struck_;
  std::vector<Touching> touching_;
  PerChunk<Near> near_;
  std::vector<int> beginning_;         ///< Bodies whose flight begins.
  std::vector<double> first_impacts_;  ///< By candidate: when it meets first. [s]
  UnionFind islands_;                  ///< Of bodies.
  std::span<const int> island_;        ///< By body: who stands for its island.
  UnionFind crowds_;                   ///< Of bodies: what strikes with what it strikes.
  std::vector<std::pair<int, int>> strikers_;
  std::vector<char> holds_;  ///< By body that stands for a island: whether one is held.
  std::vector<int> island_size_;  ///< By body that stands for a island.
  int max_island_size_ = 0;       ///< Bodies of a island that takes part in a impact.
  // The contacts of each island of what is held, as lists.
  std::vector<int> first_of_island_;  ///< By body that stands for a island; −1: none.
  std::vector<int> next_of_island_;   ///< By contact; −1: the last.
  bool islands_are_listed_ = false;

  Impact impact_;  ///< At hand.
  // Heaps with the least first: candidates that may join the impact at hand, in this look
  // and the next.
  std::vector<int> looks_;
  std::vector<int> later_;
};

}  // namespace cookbook
