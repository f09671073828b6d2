#include "engine/dynamics/contacts/contact_cache.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

#include "engine/threads/prefetch.h"

namespace cookbook {
namespace {

/** Minimum numbers of batches and of near pairs for a parallel loop: about 10
 microseconds of work. */
constexpr std::size_t kMinParallelBatches = 16;
constexpr std::size_t kMinParallelNearPairs = 2048;
/** Number of contact pairs, of half a KiB each, that no longer fit into a processor's
 cache. From then on they are sorted in spatial order, so that pairs that are solved
 together are close in memory. */
constexpr std::size_t kSortThreshold = 4096;
/** Number of steps between two sorts: the order changes little in that time, and sorting
 takes about as long as a step. */
constexpr int kSortInterval = 64;

}  // namespace

void ContactCache::Add(const RigidBody& body) {
  broad_phase_.Add(body);
  travel_.push_back(0);
}

void ContactCache::Sort() {
  broad_phase_.NumberInSpatialOrder(spatial_number_);
  const auto spatial_numbers = [&](const NearPair& pair) {
    return std::minmax(spatial_number_[static_cast<std::size_t>(pair.A)],
                       spatial_number_[static_cast<std::size_t>(pair.B)]);
  };
  // The greater number first: static bodies have the number 0, and bodies on the same
  // floor are not all neighbours.
  std::sort(near_.begin(), near_.end(), [&](const NearPair& a, const NearPair& b) {
    const auto [a_first, a_last] = spatial_numbers(a);
    const auto [b_first, b_last] = spatial_numbers(b);
    return std::tie(a_last, a_first, a.A, a.B) < std::tie(b_last, b_first, b.A, b.B);
  });
  sorted_.clear();
  for (std::size_t k = 0; k < near_.size(); ++k) {
    int& index = near_[k].contact_pair;
    if (index < 0) continue;
    sorted_.push_back(pairs_[static_cast<std::size_t>(index)]);
    sorted_.back().near = k;
    index = static_cast<int>(sorted_.size()) - 1;
  }
  pairs_.swap(sorted_);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    summaries_[k] = {pairs_[k].A, pairs_[k].B, pairs_[k].manifold.count};
  }
}

void ContactCache::BeginContact(std::size_t near) {
  near_[near].contact_pair = static_cast<int>(pairs_.size());
  ContactPair& pair = pairs_.emplace_back();
  pair.A = near_[near].A;
  pair.B = near_[near].B;
  pair.near = near;
  summaries_.push_back({pair.A, pair.B, 0});
}

void ContactCache::EndContact(std::size_t near) {
  const int index = near_[near].contact_pair;
  if (index < 0) return;
  near_[near].contact_pair = -1;
  ContactPair& pair = pairs_[static_cast<std::size_t>(index)];
  if (&pair != &pairs_.back()) {
    pair = pairs_.back();
    summaries_[static_cast<std::size_t>(index)] = summaries_.back();
    near_[pair.near].contact_pair = index;
  }
  pairs_.pop_back();
  summaries_.pop_back();
}

void ContactCache::FindCandidates(int index, const RigidBody& body, double reach,
                                  std::vector<int>& candidates) {
  new_pairs_.clear();
  broad_phase_.EnlargeProxy(index, body, reach, new_pairs_, candidates);
  for (const auto& [a, b] : new_pairs_) near_.push_back({a, b});
}

void ContactCache::Update(std::span<const RigidBody> bodies,
                          const ContactOptions& options, double ahead, ThreadPool& pool) {
  new_pairs_.clear();
  broad_phase_.Update(bodies, options.margin, ahead, pool, new_pairs_);
  for (const auto& [a, b] : new_pairs_) near_.push_back({a, b});

  if (pairs_.size() >= kSortThreshold && ++updates_since_sort_ >= kSortInterval) {
    Sort();
    updates_since_sort_ = 0;
  }

  FindPairsToCollide(options.margin, pool);
  Collide(bodies, options, pool);
  RemoveSeparatedPairs();
}

void ContactCache::FindPairsToCollide(double margin, ThreadPool& pool) {
  const auto is_due = [&](NearPair& pair) {
    // A separated pair stays separated until the bodies have travelled the gap.
    const double travel = TravelOf(pair);
    if (travel < pair.separated_until_travel) return false;
    if (broad_phase_.IsAtRest(pair.A) && broad_phase_.IsAtRest(pair.B)) return false;
    if (pair.contact_pair >= 0) return true;
    const double gap = broad_phase_.DistanceBound(pair.A, pair.B);
    if (gap <= margin) return true;
    pair.separated_until_travel = travel + gap - margin;
    return false;
  };
  // Most near pairs are neither due nor separated. One sum shows that, since the travel
  // of a body whose fat box changed counts as infinite.
  travel_bounds_ = travel_;
  broad_phase_.ForEachMoved([&](int body) {
    travel_bounds_[static_cast<std::size_t>(body)] =
        std::numeric_limits<double>::infinity();
  });
  for (PerChunk<std::size_t>* list : {&found_due_, &began_, &separated_}) {
    list->Clear(pool.chunk_count());
  }
  pool.ParallelForIndexed(near_.size(), kMinParallelNearPairs,
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
                                found_due_[chunk].push_back(k);
                                if (pair.contact_pair < 0) began_[chunk].push_back(k);
                              }
                            }
                          });
  began_.ForEach([&](std::size_t k) { BeginContact(k); });
  due_.clear();
  found_due_.AppendTo(due_);
}

void ContactCache::RemoveSeparatedPairs() {
  // Backwards, so that the pair moved into the gap is never due for removal.
  separated_.ForEachBackwards([&](std::size_t k) {
    EndContact(k);
    near_[k] = near_.back();
    const int index = near_[k].contact_pair;
    if (index >= 0) pairs_[static_cast<std::size_t>(index)].near = k;
    near_.pop_back();
  });
}

void ContactCache::Collide(std::span<const RigidBody> bodies,
                           const ContactOptions& options, ThreadPool& pool) {
  const auto pair_of = [&](std::size_t due) -> ContactPair& {
    return pairs_[static_cast<std::size_t>(near_[due_[due]].contact_pair)];
  };
  const std::size_t batches = (due_.size() + kPairsPerBatch - 1) / kPairsPerBatch;
  without_points_.Clear(pool.chunk_count());
  const auto collide = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t batch = begin; batch < end; ++batch) {
      const std::size_t first = batch * kPairsPerBatch;
      const std::size_t count = std::min(kPairsPerBatch, due_.size() - first);
      std::array<ContactPair*, kPairsPerBatch> pairs;
      for (std::size_t k = 0; k < count; ++k) {
        pairs[k] = &pair_of(first + k);
        const std::size_t later = first + k + 2 * kPairsPerBatch;
        if (later < due_.size()) Prefetch(&pair_of(later), 1);
        // Only the thread that owns the next batch may read its number of contacts.
        if (batch + 1 == end || first + k + kPairsPerBatch >= due_.size()) continue;
        const ContactPair& next = pair_of(first + k + kPairsPerBatch);
        PrefetchContacts(next, std::max(1, next.manifold.count));
        const NearPair& next_near = near_[due_[first + k + kPairsPerBatch]];
        for (const int body : {next_near.A, next_near.B}) {
          Prefetch(&bodies[static_cast<std::size_t>(body)], offsetof(RigidBody, moments));
        }
      }
      UpdateManifolds(options, bodies, std::span(pairs).first(count));
      for (std::size_t k = 0; k < count; ++k) {
        const ContactPair& pair = *pairs[k];
        summaries_[static_cast<std::size_t>(pairs[k] - pairs_.data())] = {
            pair.A, pair.B, pair.manifold.count};
        if (pair.manifold.count == 0) without_points_[chunk].push_back(due_[first + k]);
      }
    }
  };
  pool.ParallelForIndexed(batches, kMinParallelBatches, collide);

  without_points_.ForEach([&](std::size_t k) {
    NearPair& pair = near_[k];
    const Manifold& manifold =
        pairs_[static_cast<std::size_t>(pair.contact_pair)].manifold;
    pair.separated_until_travel = TravelOf(pair) + manifold.separation - options.margin;
    EndContact(k);
  });
}

}  // namespace cookbook
