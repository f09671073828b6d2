#include "engine/dynamics/solver/position_correction.h"

#include <algorithm>

namespace cookbook {
namespace {

/** Number of batches from which a parallel loop pays, see ConstraintGroup. */
constexpr std::size_t kMinParallelBatches = 12;

}  // namespace

template <class Real>
bool FindPositionCorrections(std::span<PositionConstraints<Real>> constraints,
                             const StepMotion& motion, const StepContext& step,
                             std::span<SolverVelocity<Real>> corrections) {
  const Settings& settings = step.settings;
  const auto is_empty = [](const PositionConstraints<Real>& list) {
    return list.batches.empty();
  };
  if (std::all_of(constraints.begin(), constraints.end(), is_empty)) return false;
  const PositionParameters parameters{step.h, settings.position_correction_fraction};

  std::fill(corrections.begin(), corrections.end(), SolverVelocity<Real>{});
  const auto iterate = [&](const auto& solve) {
    for (int k = 0; k < settings.position_iterations; ++k) solve();
  };
  const std::size_t threads = constraints.size() - 1;
  std::size_t batches = 0;
  for (const PositionConstraints<Real>& own : constraints.first(threads)) {
    batches += own.batches.size();
  }
  const std::size_t min_count = batches < kMinParallelBatches ? threads + 1 : 0;
  step.pool.ParallelFor(threads, min_count, [&](std::size_t begin, std::size_t end) {
    for (PositionConstraints<Real>& own : constraints.subspan(begin, end - begin)) {
      // One group after the other: a group stays in the cache for all its iterations.
      for (std::size_t k = 0; k < own.group_starts.size(); ++k) {
        const std::size_t first = own.group_starts[k];
        const std::size_t last = k + 1 < own.group_starts.size() ? own.group_starts[k + 1]
                                                                 : own.batches.size();
        const PositionConstraintView<Real> group{
            std::span(own.batches).subspan(first, last - first), own.contacts};
        PreparePositionConstraints(group, parameters, motion);
        iterate([&] { SolvePositionConstraints(group, corrections); });
      }
    }
  });

  // The list that all threads share, one colour after the other.
  PositionConstraints<Real>& shared = constraints.back();
  const PositionConstraintView<Real> view{shared.batches, shared.contacts};
  const auto view_of = [&](std::size_t begin, std::size_t end) {
    return PositionConstraintView<Real>{view.batches.subspan(begin, end - begin),
                                        view.contacts};
  };
  step.pool.ParallelFor(
      view.batches.size(), kMinParallelBatches, [&](std::size_t begin, std::size_t end) {
        PreparePositionConstraints<Real>(view_of(begin, end), parameters, motion);
      });
  iterate([&] {
    for (std::size_t k = 0; k < shared.colour_starts.size(); ++k) {
      const std::size_t first = shared.colour_starts[k];
      const std::size_t last = k + 1 < shared.colour_starts.size()
                                   ? shared.colour_starts[k + 1]
                                   : shared.batches.size();
      step.pool.ParallelFor(last - first, kMinParallelBatches,
                            [&](std::size_t begin, std::size_t end) {
                              SolvePositionConstraints<Real>(
                                  view_of(first + begin, first + end), corrections);
                            });
    }
  });
  return true;
}

template bool FindPositionCorrections<double>(std::span<PositionConstraints<double>>,
                                              const StepMotion&, const StepContext&,
                                              std::span<Velocity>);
template bool FindPositionCorrections<float>(std::span<PositionConstraints<float>>,
                                             const StepMotion&, const StepContext&,
                                             std::span<SingleVelocity>);

}  // namespace cookbook
