#include "engine/dynamics/solver/constraint_group.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <type_traits>

namespace cookbook {
namespace {

/** Number of batches of a colour from which a parallel loop pays. A batch takes about a
 quarter of a microsecond, for four pairs in doubles or sixteen in floats. */
constexpr std::size_t kMinParallelBatches = 12;

/** A maximum that several threads update. */
class AtomicMax {
 public:
  explicit AtomicMax(double start = 0) : value_(start) {}

  void Update(double value) {
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
void ConstraintGroup<Real>::BuildBatches(std::span<const ColouredPair> ordered,
                                         int null_body) {
  colour_starts_.clear();
  constraint_count_ = 0;
  int contacts = 0;
  int colour = -1;
  std::size_t used = 0;  // Number of batches.
  std::size_t lane = kLanes<Real>;
  for (const ColouredPair& next : ordered) {
    const bool starts_colour = next.colour != colour || next.colour == kLastColour;
    if (lane == kLanes<Real> || starts_colour) {
      if (starts_colour) colour_starts_.push_back(used);
      colour = next.colour;
      lane = 0;
      // PrepareContacts() overwrites whatever the last step left in a batch.
      if (used == batches_.size()) batches_.emplace_back();
      ConstraintBatch<Real>& batch = batches_[used++];
      batch.pair.fill(-1);
      batch.A.fill(null_body);
      batch.B.fill(null_body);
      batch.first = contacts;
      batch.count = 0;
      batch.is_active = true;
    }
    ConstraintBatch<Real>& batch = batches_[used - 1];
    batch.pair[lane] = next.pair;
    batch.A[lane] = next.A;
    batch.B[lane] = next.B;
    constraint_count_ += next.count;
    contacts += std::max(0, next.count - batch.count);
    batch.count = std::max(batch.count, next.count);
    ++lane;
  }
  colour_starts_.push_back(used);
  batches_.resize(used);
  contacts_.resize(static_cast<std::size_t>(contacts));
  cold_.resize(static_cast<std::size_t>(contacts));
}

template <class Real>
template <class Work>
void ConstraintGroup<Real>::ForEachColour(ThreadPool& pool, const Work& work) {
  for (std::size_t k = 0; k + 1 < colour_starts_.size(); ++k) {
    const std::span<ConstraintBatch<Real>> colour = std::span(batches_).subspan(
        colour_starts_[k], colour_starts_[k + 1] - colour_starts_[k]);
    pool.ParallelFor(
        colour.size(), kMinParallelBatches, [&](std::size_t begin, std::size_t end) {
          work(
              ConstraintView<Real>{colour.subspan(begin, end - begin), contacts_, cold_});
        });
  }
}

template <class Real>
void ConstraintGroup<Real>::Begin(std::span<const ColouredPair> ordered,
                                  std::span<const ContactPair> pairs,
                                  const SolverBodies& bodies,
                                  const ContactParameters& parameters,
                                  Velocities velocities, ThreadPool& pool) {
  parameters_ = parameters;
  BuildBatches(ordered, static_cast<int>(bodies.rigid_bodies.size()));
  AtomicMax max_speed;
  ForEachColour(pool, [&](const ConstraintView<Real>& constraints) {
    max_speed.Update(PrepareContacts(constraints, parameters, pairs, bodies));
  });
  max_speed_ = max_speed.value();
  // Warm start only now: the preparation reads the velocities without impulses.
  ApplyImpulses(velocities, pool);
}

template <class Real>
void ConstraintGroup<Real>::ApplyImpulses(Velocities velocities, ThreadPool& pool) {
  ForEachColour(pool, [&](const ConstraintView<Real>& constraints) {
    WarmStartContacts(constraints, velocities);
  });
}

template <class Real>
double ConstraintGroup<Real>::Iterate(double relaxation, Velocities velocities,
                                      ThreadPool& pool) {
  AtomicMax change;
  AtomicMax negated_min(-std::numeric_limits<double>::infinity());
  ForEachColour(pool, [&](const ConstraintView<Real>& constraints) {
    const VelocityChanges changes =
        SolveContacts(constraints, parameters_, relaxation, velocities);
    change.Update(changes.max);
    negated_min.Update(-changes.min);
  });
  min_change_ = -negated_min.value();
  return change.value();
}

template <class Real>
void ConstraintGroup<Real>::FreezeConvergedIslands(double solved,
                                                   std::span<const int> islands,
                                                   std::span<double> island_changes) {
  // The island of a pair is that of a moving body; if both move, they have the same.
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
    if (!batch.is_active) return;
    double& change = change_of(batch, lane);
    change = std::max(change, double{batch.max_change[lane]});
  });
  constraint_count_ = 0;
  for (ConstraintBatch<Real>& batch : batches_) batch.is_active = false;
  for_each_pair([&](ConstraintBatch<Real>& batch, std::size_t lane) {
    if (change_of(batch, lane) <= solved) return;
    batch.is_active = true;
    for (int k = 0; k < batch.count; ++k) {
      constraint_count_ +=
          cold_[static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k)]
              .used[lane] != 0;
    }
  });
}

template <class Real>
void ConstraintGroup<Real>::CollectPositionConstraints(
    bool rotates, PositionConstraints<Real>& constraints) {
  constraints.group_starts.push_back(constraints.batches.size());
  for (std::size_t k = 0; k + 1 < colour_starts_.size(); ++k) {
    constraints.colour_starts.push_back(constraints.batches.size());
    const std::span<ConstraintBatch<Real>> colour = std::span(batches_).subspan(
        colour_starts_[k], colour_starts_[k + 1] - colour_starts_[k]);
    CollectDeepContacts(ConstraintView<Real>{colour, contacts_, cold_}, rotates,
                        constraints);
  }
}

template <class Real>
void ConstraintGroup<Real>::StoreImpulses(std::span<ContactPair> pairs,
                                          std::span<ContactFlags> contact_flags,
                                          ThreadPool& pool) {
  ForEachColour(pool, [&](const ConstraintView<Real>& constraints) {
    StoreContactImpulses(constraints, parameters_, pairs, contact_flags);
  });
}

template <class Real>
void ConstraintGroup<Real>::ApplyToBodies(const SolverBodies& bodies, ThreadPool& pool) {
  ForEachColour(pool, [&](const ConstraintView<Real>& constraints) {
    if constexpr (std::is_same_v<Real, float>) {
      ApplyImpulsesInDouble(constraints, bodies);
    } else {
      WarmStartContacts(constraints, bodies.velocities);
    }
  });
}

template class ConstraintGroup<double>;
template class ConstraintGroup<float>;

}  // namespace cookbook
