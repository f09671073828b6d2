#include "engine/dynamics/solver/position_correction.h"

#include <algorithm>

namespace cookbook {
namespace {

/** Batches below which it does not pay to share them out: see ConstraintGroup. */
constexpr std::size_t kFewBatches = 12;

/** Share of the excess that a large world removes at most. A few sweeps lift the one and
 not yet the other: what is lifted off by more than the margin loses its contacts, and
 with them the impulses to start from, so that all that rests on it sinks in. A pile of
 30 layers was 96 mm deep in itself where each step took 0.45. */
constexpr double kLargeShare = 0.2;

}  // namespace

template <class Real>
bool FindPositionCorrections(std::span<Overlaps<Real>> overlaps, bool is_large,
                             const StepMotion& motion, const StepContext& step,
                             std::span<SolverVelocity<Real>> corrections) {
  const Settings& settings = step.settings;
  const auto is_empty = [](const Overlaps<Real>& some) { return some.batches.empty(); };
  if (std::all_of(overlaps.begin(), overlaps.end(), is_empty)) return false;
  const double share = is_large
                           ? std::min(settings.position_correction_fraction, kLargeShare)
                           : settings.position_correction_fraction;
  const PositionRules rules{step.h, share};

  std::fill(corrections.begin(), corrections.end(), SolverVelocity<Real>{});
  const auto for_each_sweep = [&](const auto& remove) {
    for (int k = 0; k < settings.position_iterations; ++k) remove();
  };
  const std::size_t threads = overlaps.size() - 1;
  std::size_t batches = 0;
  for (const Overlaps<Real>& own : overlaps.first(threads)) batches += own.batches.size();
  const std::size_t least = batches < kFewBatches ? threads + 1 : 0;
  step.pool.ParallelFor(threads, least, [&](std::size_t begin, std::size_t end) {
    for (Overlaps<Real>& own : overlaps.subspan(begin, end - begin)) {
      // Group after group: each stays in a processor's cache for all its sweeps.
      for (std::size_t k = 0; k < own.groups.size(); ++k) {
        const std::size_t first = own.groups[k];
        const std::size_t last =
            k + 1 < own.groups.size() ? own.groups[k + 1] : own.batches.size();
        const PositionConstraintView<Real> rows{
            std::span(own.batches).subspan(first, last - first), own.rows};
        FindExcess(rows, rules, motion);
        for_each_sweep([&] { RemoveExcess(rows, corrections); });
      }
    }
  });

  Overlaps<Real>& shared = overlaps.back();
  const PositionConstraintView<Real> rows{shared.batches, shared.rows};
  step.pool.ParallelFor(
      rows.batches.size(), kFewBatches, [&](std::size_t begin, std::size_t end) {
        FindExcess<Real>({rows.batches.subspan(begin, end - begin), rows.overlaps}, rules,
                         motion);
      });
  for_each_sweep([&] {
    for (std::size_t k = 0; k < shared.firsts.size(); ++k) {
      const std::size_t first = shared.firsts[k];
      const std::size_t last =
          k + 1 < shared.firsts.size() ? shared.firsts[k + 1] : shared.batches.size();
      step.pool.ParallelFor(
          last - first, kFewBatches, [&](std::size_t begin, std::size_t end) {
            RemoveExcess<Real>(
                {rows.batches.subspan(first + begin, end - begin), rows.overlaps},
                corrections);
          });
    }
  });
  return true;
}

template bool FindPositionCorrections<double>(std::span<Overlaps<double>>, bool,
                                              const StepMotion&, const StepContext&,
                                              std::span<Velocity>);
template bool FindPositionCorrections<float>(std::span<Overlaps<float>>, bool,
                                             const StepMotion&, const StepContext&,
                                             std::span<SingleVelocity>);

}  // namespace cookbook
