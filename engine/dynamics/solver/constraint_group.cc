#include "engine/dynamics/solver/constraint_group.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <type_traits>

namespace cookbook {
namespace {

/** Batches of a colour below which it does not pay to share them out: a batch takes about
 a quarter of a microsecond, of four pairs by doubles or of sixteen by floats. */
constexpr std::size_t kFewBatches = 12;

/** The greatest of numbers that several threads note. */
class Greatest {
 public:
  explicit Greatest(double start = 0) : value_(start) {}

  void Note(double value) {
    double known = value_.load(std::memory_order_relaxed);
    while (value > known &&
           !value_.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
  }
  double value() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<double> value_;
};

}  // namespace

template <class Real>
void ConstraintGroup<Real>::LayOut(std::span<const ColouredPair> ordered, int nobody) {
  firsts_.clear();
  constraint_count_ = 0;
  int rows = 0;
  int colour = -1;
  std::size_t used = 0;  // Batches.
  std::size_t lane = kLanes<Real>;
  for (const ColouredPair& next : ordered) {
    const bool starts_colour = next.colour != colour || next.colour == kLastColour;
    if (lane == kLanes<Real> || starts_colour) {
      if (starts_colour) firsts_.push_back(used);
      colour = next.colour;
      lane = 0;
      // What a step before has left in a batch is filled anew: it need not be cleared.
      if (used == batches_.size()) batches_.emplace_back();
      ConstraintBatch<Real>& batch = batches_[used++];
      batch.pair.fill(-1);
      batch.A.fill(nobody);
      batch.B.fill(nobody);
      batch.first = rows;
      batch.count = 0;
      batch.at_work = true;
    }
    ConstraintBatch<Real>& batch = batches_[used - 1];
    batch.pair[lane] = next.pair;
    batch.A[lane] = next.A;
    batch.B[lane] = next.B;
    constraint_count_ += next.count;
    rows += std::max(0, next.count - batch.count);
    batch.count = std::max(batch.count, next.count);
    ++lane;
  }
  firsts_.push_back(used);
  batches_.resize(used);
  contacts_.resize(static_cast<std::size_t>(rows));
  notes_.resize(static_cast<std::size_t>(rows));
}

template <class Real>
template <class Work>
void ConstraintGroup<Real>::ShareByColour(ThreadPool& pool, const Work& work) {
  for (std::size_t k = 0; k + 1 < firsts_.size(); ++k) {
    const std::span<ConstraintBatch<Real>> colour =
        std::span(batches_).subspan(firsts_[k], firsts_[k + 1] - firsts_[k]);
    pool.ParallelFor(colour.size(), kFewBatches, [&](std::size_t begin, std::size_t end) {
      work(ConstraintView<Real>{colour.subspan(begin, end - begin), contacts_, notes_});
    });
  }
}

template <class Real>
void ConstraintGroup<Real>::Begin(std::span<const ColouredPair> ordered,
                                  std::span<const ContactPair> pairs,
                                  const SolverBodies& world, const ContactRules& rules,
                                  Velocities velocities, ThreadPool& pool) {
  rules_ = rules;
  LayOut(ordered, static_cast<int>(world.bodies.size()));
  Greatest scale;
  ShareByColour(pool, [&](const ConstraintView<Real>& rows) {
    scale.Note(PrepareContacts(rows, rules, pairs, world));
  });
  scale_ = scale.value();
  // All rows have seen the velocities without impulses: now apply those to start from.
  ShareByColour(
      pool, [&](const ConstraintView<Real>& rows) { ApplyImpulses(rows, velocities); });
}

template <class Real>
double ConstraintGroup<Real>::Iterate(double relaxation, Velocities velocities,
                                      ThreadPool& pool) {
  Greatest change;
  Greatest closeness(-std::numeric_limits<double>::infinity());  // −(least change).
  ShareByColour(pool, [&](const ConstraintView<Real>& rows) {
    const Changes changes = SolveContacts(rows, rules_, relaxation, velocities);
    change.Note(changes.greatest);
    closeness.Note(-changes.least);
  });
  least_change_ = -closeness.value();
  return change.value();
}

template <class Real>
void ConstraintGroup<Real>::FreezeConvergedIslands(double solved,
                                                   std::span<const int> islands,
                                                   std::span<double> island_changes) {
  if (least_change_ > solved) return;  // No pair is solved, and so no island.
  // A lane of its own says of each pair which of its bodies moves; both are in one
  // island.
  const auto change_of = [&](const ConstraintBatch<Real>& batch,
                             std::size_t lane) -> double& {
    const int body = batch.inverse_mass_A[lane] > 0 ? batch.A[lane] : batch.B[lane];
    return island_changes[static_cast<std::size_t>(
        islands[static_cast<std::size_t>(body)])];
  };
  const auto for_each_pair = [&](const auto& visit) {
    for (ConstraintBatch<Real>& batch : batches_) {
      for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
        if (batch.pair[lane] >= 0) visit(batch, lane);
      }
    }
  };
  for_each_pair([&](const ConstraintBatch<Real>& batch, std::size_t lane) {
    change_of(batch, lane) = 0;
  });
  for_each_pair([&](const ConstraintBatch<Real>& batch, std::size_t lane) {
    if (!batch.at_work) return;
    double& change = change_of(batch, lane);
    change = std::max(change, double{batch.change[lane]});
  });
  constraint_count_ = 0;
  for (ConstraintBatch<Real>& batch : batches_) batch.at_work = false;
  for_each_pair([&](ConstraintBatch<Real>& batch, std::size_t lane) {
    if (change_of(batch, lane) <= solved) return;
    batch.at_work = true;
    for (int k = 0; k < batch.count; ++k) {
      constraint_count_ +=
          notes_[static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k)]
              .used[lane] != 0;
    }
  });
}

template <class Real>
void ConstraintGroup<Real>::CollectPositionConstraints(bool turns,
                                                       Overlaps<Real>& overlaps) {
  overlaps.groups.push_back(overlaps.batches.size());
  for (std::size_t k = 0; k + 1 < firsts_.size(); ++k) {
    overlaps.firsts.push_back(overlaps.batches.size());
    const std::span<ConstraintBatch<Real>> colour =
        std::span(batches_).subspan(firsts_[k], firsts_[k + 1] - firsts_[k]);
    CollectDeepContacts(ConstraintView<Real>{colour, contacts_, notes_}, turns, overlaps);
  }
}

template <class Real>
void ConstraintGroup<Real>::StoreImpulses(std::span<ContactPair> pairs,
                                          std::span<Touch> touches, ThreadPool& pool) {
  ShareByColour(pool, [&](const ConstraintView<Real>& rows) {
    ReadContacts(rows, pairs, touches);
  });
}

template <class Real>
void ConstraintGroup<Real>::Apply(const SolverBodies& world, ThreadPool& pool) {
  if constexpr (std::is_same_v<Real, float>) {
    ShareByColour(pool, [&](const ConstraintView<float>& rows) {
      ApplyFoundImpulses(rows, world);
    });
  }
}

template class ConstraintGroup<double>;
template class ConstraintGroup<float>;

}  // namespace cookbook
