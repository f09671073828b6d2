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
void CollectDeep(const ConstraintView<Real>& contacts, bool rotates,
                 PositionConstraints<Real>& constraints) {
  using V = Vec<Real>;
  const V zero{};
  const V one = Splat<Real>(1);
  for (const ConstraintBatch<Real>& batch : contacts.batches) {
    const std::size_t first = constraints.contacts.size();
    const V linear_response = Load(batch.inverse_mass_A) + Load(batch.inverse_mass_B);
    for (int k = 0; k < batch.count; ++k) {
      const auto index =
          static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k);
      const ContactColdLanes<Real>& cold = contacts.cold[index];
      const V depth = zero - Load(cold.separation) - Load(cold.slop);
      const VecBits<Real> is_deep =
          (depth > zero) & (Load(cold.used) > zero) & ~(Load(cold.bounces) > zero);
      if (Bits(is_deep) == 0) continue;
      const V response = rotates ? Load(cold.normal_response) : linear_response;
      PositionConstraintLanes<Real>& contact = constraints.contacts.emplace_back();
      contact.r_A = contacts.contacts[index].r_A;
      contact.r_B = contacts.contacts[index].r_B;
      Store(depth, contact.depth);
      Store(Select(is_deep, one / response, zero), contact.effective_mass);
    }
    const std::size_t count = constraints.contacts.size() - first;
    if (count == 0) continue;
    PositionConstraintBatch<Real>& added = constraints.batches.emplace_back();
    added.A = batch.A;
    added.B = batch.B;
    added.first = static_cast<int>(first);
    added.count = static_cast<int>(count);
    added.n = batch.n;
    added.load_speed = batch.load_speed;
    added.inverse_mass_A = batch.inverse_mass_A;
    added.inverse_mass_B = batch.inverse_mass_B;
    if (!rotates) continue;
    added.inverse_inertia_A = batch.inverse_inertia_A;
    added.inverse_inertia_B = batch.inverse_inertia_B;
  }
}

template <class Real>
void Prepare(const PositionConstraintView<Real>& constraints,
             const PositionParameters& parameters, const Velocity* mean,
             const Velocity* solved) {
  using V = Vec<Real>;
  const V zero{};
  const V h = Splat<Real>(parameters.h);
  const V fraction = Splat<Real>(parameters.fraction);
  for (PositionConstraintBatch<Real>& batch : constraints.batches) {
    const PairVelocities<Real> during_step =
        GatherPairVelocities<Real>(mean, batch.A, batch.B);
    const PairVelocities<Real> at_end =
        GatherPairVelocities<Real>(solved, batch.A, batch.B);
    const Vec3<Real> n = Load(batch.n);
    VecBits<Real> any{};
    PositionConstraintLanes<Real>* contacts =
        &constraints.contacts[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      PositionConstraintLanes<Real>& contact = contacts[k];
      const Vec3<Real> r_A = Load(contact.r_A);
      const Vec3<Real> r_B = Load(contact.r_B);
      // Remaining depth: the bodies have moved since the contacts were found.
      const V separated = h * Dot(n, during_step.RelativeAt(r_A, r_B));
      const V depth = Load(contact.depth) - separated;
      // A contact that separates by itself needs no correction: it would add energy.
      const V separating_speed = Dot(n, at_end.RelativeAt(r_A, r_B));
      const VecBits<Real> separates =
          separating_speed > Load(batch.load_speed) + fraction * depth / h;
      const V mass = Load(contact.effective_mass);
      const VecBits<Real> is_active = (mass > zero) & (depth > zero) & ~separates;
      any |= is_active;
      Store(Select(is_active, mass, zero), contact.effective_mass);
      Store(fraction * depth, contact.target);
      Store(zero, contact.impulse);
    }
    batch.is_active = Bits(any) != 0;
  }
}

template <class Real>
void Solve(const PositionConstraintView<Real>& constraints,
           SolverVelocity<Real>* corrections) {
  using V = Vec<Real>;
  const V zero{};
  for (const PositionConstraintBatch<Real>& batch : constraints.batches) {
    if (!batch.is_active) continue;
    BodyVelocities<Real> A = Gather(corrections, batch.A);
    BodyVelocities<Real> B = Gather(corrections, batch.B);
    const InverseInertias<Real> m = LoadInverseInertias<Real>(batch);
    const Vec3<Real> n = Load(batch.n);
    PositionConstraintLanes<Real>* contacts =
        &constraints.contacts[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      PositionConstraintLanes<Real>& contact = contacts[k];
      const Vec3<Real> r_A = Load(contact.r_A);
      const Vec3<Real> r_B = Load(contact.r_B);
      // Separation so far.
      const V separation = Dot(n, RelativeVelocity(A, B, r_A, r_B));
      // Clamp the accumulated pseudo-impulse.
      const V old_impulse = Load(contact.impulse);
      const V impulse = Max(zero, old_impulse + Load(contact.effective_mass) *
                                                    (Load(contact.target) - separation));
      Store(impulse, contact.impulse);
      // Apply.
      ApplyImpulse(Times(impulse - old_impulse, n), r_A, r_B, m, A, B);
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
void CollectDeepContacts(const ConstraintView<Real>& contacts, bool rotates,
                         PositionConstraints<Real>& constraints) {
  COOKBOOK_DISPATCH(CollectDeep<Real>)(contacts, rotates, constraints);
}
COOKBOOK_INSTANTIATE(CollectDeepContacts);

template <class Real>
void PreparePositionConstraints(const PositionConstraintView<Real>& constraints,
                                const PositionParameters& parameters,
                                const StepMotion& motion) {
  COOKBOOK_DISPATCH(Prepare<Real>)
  (constraints, parameters, motion.mean.data(), motion.solved.data());
}
COOKBOOK_INSTANTIATE(PreparePositionConstraints);

template <class Real>
void SolvePositionConstraints(const PositionConstraintView<Real>& constraints,
                              std::span<SolverVelocity<Real>> corrections) {
  COOKBOOK_DISPATCH(Solve<Real>)(constraints, corrections.data());
}
COOKBOOK_INSTANTIATE(SolvePositionConstraints);
}  // namespace cookbook
#endif
