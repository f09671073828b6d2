#include <algorithm>

#include "engine/dynamics/overlap_batch.h"

// Four lanes are one register from AVX2 on; wider ones would add nothing.
#define HWY_DISABLED_TARGETS                                                          \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dynamics/overlap_kernel.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "engine/dynamics/four_bodies.h"
#include "engine/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

void Find(const OverlapRows& rows, const OverlapRules& rules, const Velocity* mean,
          const Velocity* solved) {
  const Four zero{};
  const Four share = Splat(rules.share);
  for (OverlapBatch& batch : rows.batches) {
    const Moving A_mean = Gather(mean, batch.A);
    const Moving B_mean = Gather(mean, batch.B);
    const Moving A_now = Gather(solved, batch.A);
    const Moving B_now = Gather(solved, batch.B);
    const Four3 n = At(batch.n);
    FourBits any{};
    OverlapLanes* of_batch = &rows.overlaps[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      OverlapLanes& overlap = of_batch[k];
      const Four3 r_A = At(overlap.r_A);
      const Four3 r_B = At(overlap.r_B);
      const Four gone =
          Splat(rules.h) * Dot(n, RelativeVelocity(A_mean, B_mean, r_A, r_B));
      const Four excess = At(overlap.depth) - gone;
      // What parts by itself needs no help, and help would be energy from nowhere.
      const Four parting = Dot(n, RelativeVelocity(A_now, B_now, r_A, r_B));
      const FourBits parts = parting > At(batch.usual) + share * excess / Splat(rules.h);
      const Four mass = At(overlap.mass);
      const FourBits counts = (mass > zero) & (excess > zero) & ~parts;
      any |= counts;
      Put(Select(counts, mass, zero), overlap.mass);
      Put(share * excess, overlap.excess);
      Put(zero, overlap.impulse);
    }
    batch.at_work = Bits(any) != 0;
  }
}

void Remove(const OverlapRows& rows, Velocity* moves) {
  const Four zero{};
  for (const OverlapBatch& batch : rows.batches) {
    if (!batch.at_work) continue;
    Moving A = Gather(moves, batch.A);
    Moving B = Gather(moves, batch.B);
    const Inertias m = InertiasOf(batch);
    const Four3 n = At(batch.n);
    OverlapLanes* of_batch = &rows.overlaps[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      OverlapLanes& overlap = of_batch[k];
      const Four3 r_A = At(overlap.r_A);
      const Four3 r_B = At(overlap.r_B);
      const Four gained = Dot(n, RelativeVelocity(A, B, r_A, r_B));
      const Four start = At(overlap.impulse);
      const Four impulse =
          Max(zero, start + At(overlap.mass) * (At(overlap.excess) - gained));
      Put(impulse, overlap.impulse);
      Apply(Times(impulse - start, n), r_A, r_B, m, A, B);
    }
    Scatter(A, batch.A, batch.inverse_mass_A, moves);
    Scatter(B, batch.B, batch.inverse_mass_B, moves);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(Find);
HWY_EXPORT(Remove);

void FindExcess(const OverlapRows& rows, const OverlapRules& rules,
                std::span<const Velocity> mean, std::span<const Velocity> solved) {
  HWY_DYNAMIC_DISPATCH(Find)(rows, rules, mean.data(), solved.data());
}

void RemoveExcess(const OverlapRows& rows, std::span<Velocity> moves) {
  HWY_DYNAMIC_DISPATCH(Remove)(rows, moves.data());
}
}  // namespace cookbook
#endif
