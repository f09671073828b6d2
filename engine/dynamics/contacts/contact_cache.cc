#include "engine/dynamics/contacts/contact_cache.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

#include "engine/threads/prefetch.h"

namespace cookbook {
namespace {

/** Groups of pairs, and near pairs, below which it does not pay to share them out: some
 10 microseconds. */
constexpr std::size_t kFewGroups = 16;
constexpr std::size_t kFewNear = 2048;
/** Pairs, of half a KiB, that do not fit a processor's cache. More of them are sorted by
 place, so that what is solved together lies together. */
constexpr std::size_t kManyPairs = 4096;
/** Steps until so many are sorted again: what has changed of their order by then is
 little, and sorting takes about as long as a step. */
constexpr int kSorted = 64;

}  // namespace

void ContactCache::Add(const RigidBody& body) {
  broad_phase_.Add(body);
  travel_.push_back(0);
}

void ContactCache::Sort() {
  broad_phase_.NumberInSpatialOrder(number_);
  const auto numbers = [&](const NearPair& pair) {
    return std::minmax(number_[static_cast<std::size_t>(pair.A)],
                       number_[static_cast<std::size_t>(pair.B)]);
  };
  // By the later of two: what is static has number 0, and all that touches a floor is not
  // at one place.
  std::sort(near_.begin(), near_.end(), [&](const NearPair& a, const NearPair& b) {
    const auto [a_first, a_last] = numbers(a);
    const auto [b_first, b_last] = numbers(b);
    return std::tie(a_last, a_first, a.A, a.B) < std::tie(b_last, b_first, b.A, b.B);
  });
  sorted_.clear();
  for (std::size_t k = 0; k < near_.size(); ++k) {
    int& contact = near_[k].contact;
    if (contact < 0) continue;
    sorted_.push_back(contacts_[static_cast<std::size_t>(contact)]);
    sorted_.back().near = k;
    contact = static_cast<int>(sorted_.size()) - 1;
  }
  contacts_.swap(sorted_);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    edges_[k] = {contacts_[k].A, contacts_[k].B, contacts_[k].manifold.count};
  }
}

void ContactCache::Join(std::size_t near) {
  near_[near].contact = static_cast<int>(contacts_.size());
  ContactPair& pair = contacts_.emplace_back();
  pair.A = near_[near].A;
  pair.B = near_[near].B;
  pair.near = near;
  edges_.push_back({pair.A, pair.B, 0});
}

void ContactCache::Part(std::size_t near) {
  const int contact = near_[near].contact;
  if (contact < 0) return;
  near_[near].contact = -1;
  ContactPair& pair = contacts_[static_cast<std::size_t>(contact)];
  if (&pair != &contacts_.back()) {
    pair = contacts_.back();
    edges_[static_cast<std::size_t>(contact)] = edges_.back();
    near_[pair.near].contact = contact;
  }
  contacts_.pop_back();
  edges_.pop_back();
}

void ContactCache::Widen(int index, const RigidBody& body, double reach,
                         std::vector<int>& met) {
  appeared_.clear();
  broad_phase_.EnlargeProxy(index, body, reach, appeared_, met);
  for (const auto& [a, b] : appeared_) near_.push_back({a, b});
}

void ContactCache::Find(std::span<const RigidBody> bodies, const ContactChoice& choice,
                        double ahead, ThreadPool& pool) {
  appeared_.clear();
  broad_phase_.Update(bodies, choice.margin, ahead, pool, appeared_);
  for (const auto& [a, b] : appeared_) near_.push_back({a, b});

  if (contacts_.size() >= kManyPairs && ++unsorted_ >= kSorted) {
    Sort();
    unsorted_ = 0;
  }

  FindDue(choice.margin, pool);
  Collide(bodies, choice, pool);
  RemoveSeparatedPairs();
}

void ContactCache::FindDue(double margin, ThreadPool& pool) {
  const auto is_due = [&](NearPair& pair) {
    // What was apart by a gap stays apart until the two have gone that far.
    const double gone = TravelOf(pair);
    if (gone < pair.separated_until_travel) return false;
    if (broad_phase_.IsAtRest(pair.A) && broad_phase_.IsAtRest(pair.B)) return false;
    if (pair.contact >= 0) return true;
    const double gap = broad_phase_.DistanceBound(pair.A, pair.B);
    if (gap <= margin) return true;
    pair.separated_until_travel = gone + gap - margin;
    return false;
  };
  // Most near pairs are neither due nor strangers: known by one sum, as if what has left
  // its wide box had gone however far.
  travel_bounds_ = travel_;
  broad_phase_.ForEachMoved([&](int body) {
    travel_bounds_[static_cast<std::size_t>(body)] =
        std::numeric_limits<double>::infinity();
  });
  for (PerChunk<std::size_t>* findings : {&found_, &new_, &separated_}) {
    findings->Clear(pool.chunk_count());
  }
  pool.ParallelForIndexed(near_.size(), kFewNear,
                          [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                            for (std::size_t k = begin; k < end; ++k) {
                              NearPair& pair = near_[k];
                              if (travel_bounds_[static_cast<std::size_t>(pair.A)] +
                                      travel_bounds_[static_cast<std::size_t>(pair.B)] <
                                  pair.separated_until_travel) {
                                continue;
                              }
                              if (!broad_phase_.AreStillNear(pair.A, pair.B)) {
                                separated_[chunk].push_back(k);
                              } else if (is_due(pair)) {
                                found_[chunk].push_back(k);
                                if (pair.contact < 0) new_[chunk].push_back(k);
                              }
                            }
                          });
  new_.ForEach([&](std::size_t k) { Join(k); });
  due_.clear();
  found_.AppendTo(due_);
}

void ContactCache::RemoveSeparatedPairs() {
  // The last first: what takes its place stays.
  separated_.ForEachBackwards([&](std::size_t k) {
    Part(k);
    near_[k] = near_.back();
    const int contact = near_[k].contact;
    if (contact >= 0) contacts_[static_cast<std::size_t>(contact)].near = k;
    near_.pop_back();
  });
}

void ContactCache::Collide(std::span<const RigidBody> bodies, const ContactChoice& choice,
                           ThreadPool& pool) {
  const auto contact_of = [&](std::size_t due) -> ContactPair& {
    return contacts_[static_cast<std::size_t>(near_[due_[due]].contact)];
  };
  const std::size_t groups = (due_.size() + kNeighbours - 1) / kNeighbours;
  found_.Clear(pool.chunk_count());  // Those without a contact.
  const auto collide = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t group = begin; group < end; ++group) {
      const std::size_t first = group * kNeighbours;
      const std::size_t count = std::min(kNeighbours, due_.size() - first);
      std::array<ContactPair*, kNeighbours> pairs;
      for (std::size_t k = 0; k < count; ++k) {
        pairs[k] = &contact_of(first + k);
        const std::size_t later = first + k + 2 * kNeighbours;
        if (later < due_.size()) Prefetch(&contact_of(later), 1);
        // How many contacts a pair has is for its own thread to read.
        if (group + 1 == end || first + k + kNeighbours >= due_.size()) continue;
        const ContactPair& next = contact_of(first + k + kNeighbours);
        PrefetchContacts(next, std::max(1, next.manifold.count));
        const NearPair& next_near = near_[due_[first + k + kNeighbours]];
        for (const int body : {next_near.A, next_near.B}) {
          Prefetch(&bodies[static_cast<std::size_t>(body)], offsetof(RigidBody, moments));
        }
      }
      Recollide(choice, bodies, std::span(pairs).first(count));
      for (std::size_t k = 0; k < count; ++k) {
        const ContactPair& pair = *pairs[k];
        edges_[static_cast<std::size_t>(pairs[k] - contacts_.data())] = {
            pair.A, pair.B, pair.manifold.count};
        if (pair.manifold.count == 0) found_[chunk].push_back(due_[first + k]);
      }
    }
  };
  pool.ParallelForIndexed(groups, kFewGroups, collide);

  found_.ForEach([&](std::size_t k) {
    NearPair& pair = near_[k];
    const Manifold& manifold = contacts_[static_cast<std::size_t>(pair.contact)].manifold;
    pair.separated_until_travel = TravelOf(pair) + manifold.separation - choice.margin;
    Part(k);
  });
}

}  // namespace cookbook
