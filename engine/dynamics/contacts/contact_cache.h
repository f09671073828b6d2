#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/broad_phase/broad_phase.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/threads/per_chunk.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** Finds the contacts of a world, step after step. */
class ContactCache {
 public:
  /** Adds the body of the next index. */
  void Add(const RigidBody& body);

  /** Says that a body has got no farther than `way` [m] out of the room it filled when
   that was last said, see Travel(). */
  void AddTravel(std::size_t body, double way) { travel_[body] += way; }

  /** Brings contacts() up to date, those apart by up to `margin` [m] included. Bodies
   that may meet within `ahead` [s] are near each other. */
  void Find(std::span<const RigidBody> bodies, const ContactChoice& choice, double ahead,
            ThreadPool& pool);

  /** Appends to `met` what the moving body `index` may meet that is at `body` now and
   gets no farther than `reach` [m] in the step; both are near each other from now on. */
  void Widen(int index, const RigidBody& body, double reach, std::vector<int>& met);

  /** The pairs that have a contact, in an order that the history of the world decides. */
  std::span<ContactPair> contacts() { return contacts_; }
  std::span<const ContactPair> contacts() const { return contacts_; }
  /** The same in short. */
  std::span<const ContactEdge> edges() const { return edges_; }
  /** Leaves a pair without contacts until the next Find(). */
  void Release(std::size_t contact) {
    contacts_[contact].manifold.count = 0;
    edges_[contact].count = 0;
  }

  /** Calls `visit(A, B)` for every two bodies that are near each other. */
  template <class Visit>
  void ForEachNear(const Visit& visit) const {
    for (const NearPair& pair : near_) visit(pair.A, pair.B);
  }
  /** Calls `visit(A, B, gap)` for those from `begin` to `end` of near_count() of which
   `takes(A, B)` is true: they are apart by `gap` [m] or more. */
  template <class Takes, class Visit>
  void ForEachGap(std::size_t begin, std::size_t end, const Takes& takes,
                  const Visit& visit) const {
    for (const NearPair& pair : std::span(near_).subspan(begin, end - begin)) {
      if (!takes(pair.A, pair.B)) continue;
      visit(pair.A, pair.B,
            pair.contact >= 0 ? 0 : pair.separated_until_travel - TravelOf(pair));
    }
  }
  std::size_t near_count() const { return near_.size(); }

 private:
  /** Two bodies that the broad phase says are near. */
  struct NearPair {
    int A;
    int B;
    int contact = -1;  ///< Among contacts_; −1: none.
    /** The sum of what the two have gone up to which they surely do not touch. [m] */
    double separated_until_travel = 0;
  };

  double TravelOf(const NearPair& pair) const {
    return travel_[static_cast<std::size_t>(pair.A)] +
           travel_[static_cast<std::size_t>(pair.B)];
  }
  /** Sorts pairs by place. */
  void Sort();
  void Join(std::size_t near);
  void Part(std::size_t near);
  /** Finds the pairs to be looked at, and those that are near no more. */
  void FindDue(double margin, ThreadPool& pool);
  /** Looks at the former, and parts those that have no contact. */
  void Collide(std::span<const RigidBody> bodies, const ContactChoice& choice,
               ThreadPool& pool);
  /** Forgets the latter. */
  void RemoveSeparatedPairs();

  BroadPhase broad_phase_;
  std::vector<std::pair<int, int>> appeared_;
  std::vector<NearPair> near_;
  std::vector<ContactPair> contacts_;
  std::vector<ContactEdge> edges_;     ///< Of contacts_.
  std::vector<std::size_t> due_;       ///< The near pairs to be looked at in this step.
  PerChunk<std::size_t> found_;       ///< Those, or those of them that are apart.
  PerChunk<std::size_t> new_;         ///< Those of them that had no contact.
  PerChunk<std::size_t> separated_;   ///< The near pairs that are near no more.
  std::vector<double> travel_;         ///< By body. [m]
  std::vector<double> travel_bounds_;  ///< The same, infinite of what has left its box.
  int unsorted_ = 0;                   ///< Calls of Find() since pairs were sorted.
  std::vector<int> number_;            ///< By body, see BroadPhase::NumberInSpatialOrder().
  std::vector<ContactPair> sorted_;
};

}  // namespace cookbook
