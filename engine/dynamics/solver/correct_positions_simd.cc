#include <algorithm>

#include "engine/dynamics/solver/position_constraint.h"

#define HWY_TARGET_INCLUDE "engine/dynamics/solver/correct_positions_simd.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/dynamics/solver/solver_bodies_simd.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

template <class Real>
void Note(const ConstraintView<Real>& rows, bool turns, Overlaps<Real>& overlaps) {
  using V = Vec<Real>;
  const V zero{};
  const V one = All<Real>(1);
  for (const ConstraintBatch<Real>& batch : rows.batches) {
    const std::size_t first = overlaps.rows.size();
    const V slop = At(batch.slop);
    const V moved = At(batch.inverse_mass_A) + At(batch.inverse_mass_B);
    for (int k = 0; k < batch.count; ++k) {
      const auto row =
          static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k);
      const ContactNotes<Real>& note = rows.notes[row];
      const V depth = zero - At(note.separation) - slop;
      const VecBits<Real> counts =
          (depth > zero) & (At(note.used) > zero) & ~(At(note.bounces) > zero);
      if (Bits(counts) == 0) continue;
      const V response = turns ? At(note.response) : moved;
      PositionConstraintLanes<Real>& overlap = overlaps.rows.emplace_back();
      overlap.r_A = rows.contacts[row].r_A;
      overlap.r_B = rows.contacts[row].r_B;
      Put(depth, overlap.depth);
      Put(Select(counts, one / response, zero), overlap.mass);
    }
    const std::size_t count = overlaps.rows.size() - first;
    if (count == 0) continue;
    PositionConstraintBatch<Real>& noted = overlaps.batches.emplace_back();
    noted.A = batch.A;
    noted.B = batch.B;
    noted.first = static_cast<int>(first);
    noted.count = static_cast<int>(count);
    noted.n = batch.n;
    noted.usual = batch.usual;
    noted.inverse_mass_A = batch.inverse_mass_A;
    noted.inverse_mass_B = batch.inverse_mass_B;
    if (!turns) continue;
    noted.inverse_inertia_A = batch.inverse_inertia_A;
    noted.inverse_inertia_B = batch.inverse_inertia_B;
  }
}

template <class Real>
void Find(const PositionConstraintView<Real>& rows, const PositionRules& rules,
          const Velocity* mean, const Velocity* solved) {
  using V = Vec<Real>;
  const V zero{};
  const V h = All<Real>(rules.h);
  const V share = All<Real>(rules.share);
  for (PositionConstraintBatch<Real>& batch : rows.batches) {
    const Pairs<Real> moved = PairsOf<Real>(mean, batch.A, batch.B);
    const Pairs<Real> now = PairsOf<Real>(solved, batch.A, batch.B);
    const Vec3<Real> n = At(batch.n);
    VecBits<Real> any{};
    PositionConstraintLanes<Real>* of_batch =
        &rows.overlaps[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      PositionConstraintLanes<Real>& overlap = of_batch[k];
      const Vec3<Real> r_A = At(overlap.r_A);
      const Vec3<Real> r_B = At(overlap.r_B);
      const V gone = h * Dot(n, moved.At(r_A, r_B));
      const V excess = At(overlap.depth) - gone;
      // What parts by itself needs no help, and help would be energy from nowhere.
      const V parting = Dot(n, now.At(r_A, r_B));
      const VecBits<Real> parts = parting > At(batch.usual) + share * excess / h;
      const V mass = At(overlap.mass);
      const VecBits<Real> counts = (mass > zero) & (excess > zero) & ~parts;
      any |= counts;
      Put(Select(counts, mass, zero), overlap.mass);
      Put(share * excess, overlap.excess);
      Put(zero, overlap.impulse);
    }
    batch.at_work = Bits(any) != 0;
  }
}

template <class Real>
void Remove(const PositionConstraintView<Real>& rows, SolverVelocity<Real>* corrections) {
  using V = Vec<Real>;
  const V zero{};
  for (const PositionConstraintBatch<Real>& batch : rows.batches) {
    if (!batch.at_work) continue;
    Moving<Real> A = Gather(corrections, batch.A);
    Moving<Real> B = Gather(corrections, batch.B);
    const Inertias<Real> m = InertiasOf<Real>(batch);
    const Vec3<Real> n = At(batch.n);
    PositionConstraintLanes<Real>* of_batch =
        &rows.overlaps[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      PositionConstraintLanes<Real>& overlap = of_batch[k];
      const Vec3<Real> r_A = At(overlap.r_A);
      const Vec3<Real> r_B = At(overlap.r_B);
      const V gained = Dot(n, RelativeVelocity(A, B, r_A, r_B));
      const V start = At(overlap.impulse);
      const V impulse =
          Max(zero, start + At(overlap.mass) * (At(overlap.excess) - gained));
      Put(impulse, overlap.impulse);
      Apply(Times(impulse - start, n), r_A, r_B, m, A, B);
    }
    Scatter(A, batch.A, batch.inverse_mass_A, corrections);
    Scatter(B, batch.B, batch.inverse_mass_B, corrections);
  }
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
template <class Real>
void CollectDeepContacts(const ConstraintView<Real>& rows, bool turns,
                         Overlaps<Real>& overlaps) {
  COOKBOOK_DISPATCH(Note<Real>)(rows, turns, overlaps);
}
COOKBOOK_INSTANTIATE(CollectDeepContacts);

template <class Real>
void FindExcess(const PositionConstraintView<Real>& rows, const PositionRules& rules,
                const StepMotion& motion) {
  COOKBOOK_DISPATCH(Find<Real>)(rows, rules, motion.mean.data(), motion.solved.data());
}
COOKBOOK_INSTANTIATE(FindExcess);

template <class Real>
void RemoveExcess(const PositionConstraintView<Real>& rows,
                  std::span<SolverVelocity<Real>> corrections) {
  COOKBOOK_DISPATCH(Remove<Real>)(rows, corrections.data());
}
COOKBOOK_INSTANTIATE(RemoveExcess);
}  // namespace cookbook
#endif
