#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/broad_phase/broad_phase.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/threads/per_chunk.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** The contact pairs of a world, kept from step to step: broad phase, narrow phase and
 the impulses for warm starting. Pairs that cannot have come into contact since they were
 last collided are skipped. */
class ContactCache {
 public:
  /** Adds the body with the next index. */
  void Add(const RigidBody& body);

  /** Records that no point of a body has travelled farther than `distance` [m] since the
   last call, see Travel(). */
  void AddTravel(std::size_t body, double distance) { travel_[body] += distance; }

  /** Updates pairs(), including those with only speculative contact points. Bodies that
   may collide within `ahead` [s] become near pairs. */
  void Update(std::span<const RigidBody> bodies, const ContactOptions& options,
              double ahead, ThreadPool& pool);

  /** Appends to `candidates` the bodies that the moving body `index` may touch, which is
   at `body` now and travels no farther than `reach` [m] in the step. They become near
   pairs. */
  void FindCandidates(int index, const RigidBody& body, double reach,
                      std::vector<int>& candidates);

  /** Returns the contact pairs, in an order that depends on the history of the world. */
  std::span<ContactPair> pairs() { return pairs_; }
  std::span<const ContactPair> pairs() const { return pairs_; }
  /** Returns the summaries of pairs(), with the same indices. */
  std::span<const PairSummary> summaries() const { return summaries_; }
  /** Removes the contact points of a pair until the next Update(). */
  void ClearContacts(std::size_t pair) {
    pairs_[pair].manifold.count = 0;
    summaries_[pair].count = 0;
  }

  /** Calls `visit(A, B)` for every near pair. */
  template <class Visit>
  void ForEachNear(const Visit& visit) const {
    for (const NearPair& pair : near_) visit(pair.A, pair.B);
  }
  /** Calls `visit(A, B, gap)` for the near pairs with indices in [begin, end) for which
   `takes(A, B)` is true. `gap` [m] is 0 for a contact pair; otherwise the distance of the
   two bodies is at least `gap`. */
  template <class Takes, class Visit>
  void ForEachGap(std::size_t begin, std::size_t end, const Takes& takes,
                  const Visit& visit) const {
    for (const NearPair& pair : std::span(near_).subspan(begin, end - begin)) {
      if (!takes(pair.A, pair.B)) continue;
      visit(pair.A, pair.B,
            pair.contact_pair >= 0 ? 0 : pair.separated_until_travel - TravelOf(pair));
    }
  }
  /** Returns the number of near pairs. */
  std::size_t near_count() const { return near_.size(); }

 private:
  /** A near pair of the broad phase. */
  struct NearPair {
    int A;
    int B;
    int contact_pair = -1;  ///< Index in `pairs_`; −1: none.
    /** The pair is separated as long as TravelOf() is less than this. [m] */
    double separated_until_travel = 0;
  };

  /** Returns the sum of the distances that both bodies have travelled. [m] */
  double TravelOf(const NearPair& pair) const {
    return travel_[static_cast<std::size_t>(pair.A)] +
           travel_[static_cast<std::size_t>(pair.B)];
  }
  /** Sorts near pairs and contact pairs in spatial order. */
  void Sort();
  /** Adds a contact pair, without contact points yet, for a near pair. */
  void BeginContact(std::size_t near);
  /** Removes the contact pair of a near pair, if it has one. */
  void EndContact(std::size_t near);
  /** Fills `due_` and `separated_`, and adds the contact pairs of the former. */
  void FindPairsToCollide(double margin, ThreadPool& pool);
  /** Collides the near pairs in `due_`, and removes the contact pairs without a contact
   point. */
  void Collide(std::span<const RigidBody> bodies, const ContactOptions& options,
               ThreadPool& pool);
  /** Removes the near pairs in `separated_`. */
  void RemoveSeparatedPairs();

  BroadPhase broad_phase_;
  std::vector<std::pair<int, int>> new_pairs_;
  std::vector<NearPair> near_;
  std::vector<ContactPair> pairs_;
  std::vector<PairSummary> summaries_;  ///< Indexed like `pairs_`.
  std::vector<std::size_t> due_;        ///< Near pairs to be collided in this step.
  PerChunk<std::size_t> found_due_;     ///< The elements of `due_`, as chunks find them.
  PerChunk<std::size_t> without_points_;  ///< Those in `due_` without a contact point.
  PerChunk<std::size_t> began_;           ///< Those in `due_` that had no contact pair.
  PerChunk<std::size_t> separated_;       ///< Near pairs that are near no longer.
  std::vector<double> travel_;  ///< Indexed by body: distance travelled so far. [m]
  std::vector<double> travel_bounds_;  ///< The same, but infinite if the fat box changed.
  int updates_since_sort_ = 0;       ///< Number of Update() calls since the last Sort().
  std::vector<int> spatial_number_;  ///< See BroadPhase::NumberInSpatialOrder().
  std::vector<ContactPair> sorted_;  ///< Scratch memory of Sort().
};

}  // namespace cookbook
