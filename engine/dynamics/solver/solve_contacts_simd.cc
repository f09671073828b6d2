#include <algorithm>
#include <limits>
#include <span>

#include "engine/dynamics/solver/contact_constraint.h"

#define HWY_TARGET_INCLUDE "engine/dynamics/solver/solve_contacts_simd.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/dynamics/solver/solver_bodies_simd.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

template <class Real>
void WarmStart(const ConstraintView<Real>& constraints,
               SolverVelocity<Real>* velocities) {
  for (const ConstraintBatch<Real>& batch : constraints.batches) {
    BodyVelocities<Real> A = Gather(velocities, batch.A);
    BodyVelocities<Real> B = Gather(velocities, batch.B);
    const InverseInertias<Real> m = LoadInverseInertias<Real>(batch);
    const Vec3<Real> n = Load(batch.n);
    const Vec3<Real> t1 = Load(batch.t1);
    const Vec3<Real> t2 = Load(batch.t2);
    const ContactConstraintLanes<Real>* contacts =
        &constraints.contacts[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      const ContactConstraintLanes<Real>& contact = contacts[k];
      const Vec3<Real> J = Plus(Times(Load(contact.impulse), n),
                                Plus(Times(Load(contact.friction_impulse1), t1),
                                     Times(Load(contact.friction_impulse2), t2)));
      ApplyImpulse(J, Load(contact.r_A), Load(contact.r_B), m, A, B);
    }
    Scatter(A, batch.A, batch.inverse_mass_A, velocities);
    Scatter(B, batch.B, batch.inverse_mass_B, velocities);
  }
}

/** Returns the impulse on B of a contact of each pair. WarmStart() adds the three terms
 in another order, so the two differ by a rounding. */
template <class Real>
HWY_INLINE Vec3<Real> ImpulseOf(const ConstraintBatch<Real>& batch,
                                const ContactConstraintLanes<Real>& contact) {
  return Plus(Plus(Times(Load(contact.impulse), Load(batch.n)),
                   Times(Load(contact.friction_impulse1), Load(batch.t1))),
              Times(Load(contact.friction_impulse2), Load(batch.t2)));
}

/** See ApplyImpulsesInDouble(). */
void ApplyInDouble(const ConstraintView<float>& constraints, const SolverBodies& bodies) {
  Velocity* velocities = bodies.velocities.data();
  alignas(64) static const InverseInertia kImmovable{};
  alignas(32) static constexpr std::array<double, 4> kZeroPosition{};
  for (const ConstraintBatch<float>& batch : constraints.batches) {
    const ContactConstraintLanes<float>* contacts =
        &constraints.contacts[static_cast<std::size_t>(batch.first)];
    std::array<VectorLanes<float>, 8> J_W;
    for (int k = 0; k < batch.count; ++k) {
      const Vec3<float> J = ImpulseOf(batch, contacts[k]);
      VectorLanes<float>& lanes = J_W[static_cast<std::size_t>(k)];
      Store(J.x, lanes[0]);
      Store(J.y, lanes[1]);
      Store(J.z, lanes[2]);
    }
    for (std::size_t four = 0; four < kFours<float>; ++four) {
      const int* indices_A = batch.A.data() + 4 * four;
      const int* indices_B = batch.B.data() + 4 * four;
      const auto load = [&](const int* indices, Tensor<double>& tensor,
                            Vec3<double>& centre) HWY_ATTR {
        std::array<const InverseInertia*, 4> inertia;
        std::array<const double*, 4> p_WB;
        for (std::size_t k = 0; k < 4; ++k) {
          const bool is_pair = batch.pair[4 * four + k] >= 0;
          const auto body = static_cast<std::size_t>(indices[k]);
          inertia[k] = is_pair ? &bodies.inertias[body] : &kImmovable;
          p_WB[k] = is_pair ? bodies.rigid_bodies[body].state.p_WB.data()
                            : kZeroPosition.data();
        }
        Four lanes[4];
        LoadTransposed(p_WB, lanes);
        centre = {lanes[0], lanes[1], lanes[2]};
        return GatherInverseInertias(inertia, tensor);
      };
      InverseInertias<double> m;
      Vec3<double> p_A;
      Vec3<double> p_B;
      m.inverse_mass_A = load(indices_A, m.inverse_inertia_A, p_A);
      m.inverse_mass_B = load(indices_B, m.inverse_inertia_B, p_B);
      const Vec3<double> p_AB = Minus(p_B, p_A);
      const FourBits A_moves = m.inverse_mass_A > Four{};
      BodyVelocities<double> A = GatherFour(velocities, indices_A);
      BodyVelocities<double> B = GatherFour(velocities, indices_B);
      ImpulseSum<double> sum;
      for (int k = 0; k < batch.count; ++k) {
        const ContactConstraintLanes<float>& contact = contacts[k];
        const Vec3<double> J = LoadFour(J_W[static_cast<std::size_t>(k)], four);
        // Apply both impulses at the same point if both bodies move. With the rounded
        // r_B the points would differ, which adds angular momentum.
        const Vec3<double> r_A = LoadFour(contact.r_A, four);
        const Vec3<double> from_A = Minus(r_A, p_AB);
        const Vec3<double> stored = LoadFour(contact.r_B, four);
        const Vec3<double> r_B{Select(A_moves, from_A.x, stored.x),
                               Select(A_moves, from_A.y, stored.y),
                               Select(A_moves, from_A.z, stored.z)};
        sum.Add(J, r_A, r_B);
      }
      ApplyImpulse(sum, m, A, B);
      ScatterFour(A, indices_A, m.inverse_mass_A, velocities);
      ScatterFour(B, indices_B, m.inverse_mass_B, velocities);
    }
  }
}

/** The registers of a batch while it is solved. */
template <class Real>
struct BatchState {
  using V = Vec<Real>;
  static constexpr bool kTracksChange = std::is_same_v<Real, double>;

  ConstraintBatch<Real>& batch;
  ContactConstraintLanes<Real>* contacts;
  const ContactColdLanes<Real>* cold;
  BodyVelocities<Real> A;
  BodyVelocities<Real> B;
  InverseInertias<Real> m;
  Vec3<Real> n;
  Vec3<Real> t1;
  Vec3<Real> t2;
  V friction;
  V relaxation;
  V max_change{};

  /** Returns `max_change`, but +∞ in lanes without a pair. */
  HWY_INLINE V ChangeOfPairs() const {
    return Select(m.inverse_mass_A + m.inverse_mass_B > V{}, max_change,
                  Splat<Real>(std::numeric_limits<Real>::infinity()));
  }
};

template <class Real>
HWY_INLINE BatchState<Real> Begin(ConstraintBatch<Real>& batch,
                                  const ConstraintView<Real>& constraints,
                                  Vec<Real> relaxation,
                                  const SolverVelocity<Real>* velocities) {
  const auto first = static_cast<std::size_t>(batch.first);
  return {batch,
          &constraints.contacts[first],
          &constraints.cold[first],
          Gather(velocities, batch.A),
          Gather(velocities, batch.B),
          LoadInverseInertias<Real>(batch),
          Load(batch.n),
          Load(batch.t1),
          Load(batch.t2),
          Load(batch.friction),
          relaxation};
}

/** The contact model of a world. */
enum class ContactModel {
  kRigid,           ///< Rigid contacts, accumulated impulses.
  kYieldingOrSoft,  ///< Contacts that yield or are soft, accumulated impulses.
  kUnaccumulated,   ///< Rigid or soft contacts, impulses that do not accumulate.
};

/** Solves one contact of each pair. */
template <ContactModel model, class Real>
HWY_INLINE void SolveContactLanes(int index, BatchState<Real>& state) {
  using V = Vec<Real>;
  constexpr bool kAccumulates = model != ContactModel::kUnaccumulated;
  ContactConstraintLanes<Real>& contact = state.contacts[index];
  const V zero{};
  const Vec3<Real> r_A = Load(contact.r_A);
  const Vec3<Real> r_B = Load(contact.r_B);

  const Vec3<Real> u = RelativeVelocity(state.A, state.B, r_A, r_B);

  // Normal impulse: clamp the sum of the old impulse and the change that attains the
  // target. If impulses do not accumulate, `old_impulse` is 0, so that each change alone
  // is clamped; `stored_impulse` then is the sum of the changes. `softened` is the old
  // impulse less the part that the contact gives up because it is soft or yields.
  const V stored_impulse = Load(contact.impulse);
  const V old_impulse = kAccumulates ? stored_impulse : zero;
  V softened = old_impulse;
  if constexpr (model != ContactModel::kRigid) {
    const V most = Load(state.batch.max_deviation);
    const V deviation = stored_impulse - Load(contact.mean_load);
    softened = old_impulse - state.relaxation * Load(contact.impulse_scale) *
                                 Max(zero - most, Min(most, deviation));
  }
  const V mass = state.relaxation * Load(contact.effective_mass);
  const V impulse = Max(zero, softened + mass * (Load(contact.target) - Dot(u, state.n)));
  const V change = impulse - old_impulse;
  Store(kAccumulates ? impulse : stored_impulse + change, contact.impulse);

  // Slip after the normal impulse.
  V slip1 = Dot(u, state.t1) + change * Load(contact.response_n1);
  V slip2 = Dot(u, state.t2) + change * Load(contact.response_n2);
  if constexpr (std::is_same_v<Real, float>) {
    slip1 = slip1 + Load(contact.free_slip1);
    slip2 = slip2 + Load(contact.free_slip2);
  }

  // Friction: clamp the accumulated impulse to the cone. Inside the cone it is the
  // impulse that stops the slip. Else it is a step against the slip, projected onto the
  // cone: at a fixed point of this iteration the impulse is opposite to the slip.
  const V max_friction = state.friction * impulse;
  const V max_squared = max_friction * max_friction;
  const V stored1 = Load(contact.friction_impulse1);
  const V stored2 = Load(contact.friction_impulse2);
  const V old1 = kAccumulates ? stored1 : zero;
  const V old2 = kAccumulates ? stored2 : zero;
  const V tangent_mass12 = Load(contact.tangent_mass12);
  const V stick1 = old1 - (Load(contact.tangent_mass11) * slip1 + tangent_mass12 * slip2);
  const V stick2 = old2 - (tangent_mass12 * slip1 + Load(contact.tangent_mass22) * slip2);
  V change1 = stick1 - old1;
  V change2 = stick2 - old2;
  const VecBits<Real> slides = stick1 * stick1 + stick2 * stick2 > max_squared;
  // Most contacts stick, so that the branch is predicted well. It saves a square root and
  // a division, for which the next contact would have to wait.
  if (Bits(slides) != 0) {
    const V step = Load(contact.friction_step);
    const V slide1 = old1 - step * slip1;
    const V slide2 = old2 - step * slip2;
    const V length_squared = slide1 * slide1 + slide2 * slide2;
    const VecBits<Real> outside = length_squared > max_squared;
    const V length = Sqrt(Select(outside, length_squared, Splat<Real>(1)));
    const V shrink = Select(outside, max_friction / length, Splat<Real>(1));
    change1 = Select(slides, shrink * slide1, stick1) - old1;
    change2 = Select(slides, shrink * slide2, stick2) - old2;
  }
  Store(stored1 + change1, contact.friction_impulse1);
  Store(stored2 + change2, contact.friction_impulse2);

  ApplyImpulse(Plus(Times(change, state.n),
                    Plus(Times(change1, state.t1), Times(change2, state.t2))),
               r_A, r_B, state.m, state.A, state.B);

  if constexpr (BatchState<Real>::kTracksChange) {
    const ContactColdLanes<Real>& cold = state.cold[index];
    const V slip_response = Load(cold.slip_response);
    state.max_change = Max(state.max_change, Abs(change) * Load(cold.normal_response));
    state.max_change =
        Max(state.max_change, Max(Abs(change1), Abs(change2)) * slip_response);
  }
}

template <class Real>
HWY_INLINE void End(const BatchState<Real>& state, SolverVelocity<Real>* velocities) {
  if constexpr (BatchState<Real>::kTracksChange)
    Store(state.max_change, state.batch.max_change);
  Scatter(state.A, state.batch.A, state.batch.inverse_mass_A, velocities);
  Scatter(state.B, state.batch.B, state.batch.inverse_mass_B, velocities);
}

template <ContactModel model, class Real>
VelocityChanges SolveModel(const ConstraintView<Real>& constraints, double relaxation,
                           SolverVelocity<Real>* velocities) {
  using V = Vec<Real>;
  const V relaxation_lanes = Splat<Real>(relaxation);
  V max{};
  V min = Splat<Real>(std::numeric_limits<Real>::infinity());
  const std::size_t count = constraints.batches.size();
  const auto next_active = [&](std::size_t k) {
    while (k < count && !constraints.batches[k].is_active) ++k;
    return k;
  };
  // Two batches interleaved, which hides latency: a contact depends on the previous one
  // of its batch, but the batches, which have one colour, do not depend on each other.
  for (std::size_t k = next_active(0); k < count;) {
    const std::size_t next = next_active(k + 1);
    BatchState<Real> first =
        Begin<Real>(constraints.batches[k], constraints, relaxation_lanes, velocities);
    if (next == count) {
      for (int i = 0; i < first.batch.count; ++i)
        SolveContactLanes<model, Real>(i, first);
      End(first, velocities);
      max = Max(max, first.max_change);
      min = Min(min, first.ChangeOfPairs());
      break;
    }
    BatchState<Real> second =
        Begin<Real>(constraints.batches[next], constraints, relaxation_lanes, velocities);
    const int both = std::min(first.batch.count, second.batch.count);
    for (int i = 0; i < both; ++i) {
      SolveContactLanes<model, Real>(i, first);
      SolveContactLanes<model, Real>(i, second);
    }
    for (int i = both; i < first.batch.count; ++i)
      SolveContactLanes<model, Real>(i, first);
    for (int i = both; i < second.batch.count; ++i)
      SolveContactLanes<model, Real>(i, second);
    End(first, velocities);
    End(second, velocities);
    max = Max(max, Max(first.max_change, second.max_change));
    min = Min(min, Min(first.ChangeOfPairs(), second.ChangeOfPairs()));
    k = next_active(next + 1);
  }
  if constexpr (BatchState<Real>::kTracksChange) {
    return {MaxLane(max), -MaxLane(-min)};
  } else {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    return {kUnknown, kUnknown};
  }
}

template <class Real>
VelocityChanges SolveAll(const ConstraintView<Real>& constraints,
                         const ContactParameters& parameters, double relaxation,
                         SolverVelocity<Real>* velocities) {
  const bool is_rigid = parameters.soft_impulse_scale == 0 && parameters.yield == 0;
  const auto solve = !parameters.accumulated
                         ? SolveModel<ContactModel::kUnaccumulated, Real>
                     : is_rigid ? SolveModel<ContactModel::kRigid, Real>
                                : SolveModel<ContactModel::kYieldingOrSoft, Real>;
  return solve(constraints, relaxation, velocities);
}

/** Scales the mean loads of a pair to a step of `h` [s]. */
void ScaleMeanLoads(double h, ContactPair& pair) {
  if (pair.impulse_time != h && pair.impulse_time > 0) {
    for (double& load : pair.mean_load) load *= h / pair.impulse_time;
  }
  pair.impulse_time = h;
}

/** Updates the mean loads of a pair, lane `lane` of `batch`, after a step. While the pair
 is rigid they are the loads of the last step in which it was at rest. */
template <class Real>
void UpdateMeanLoads(const ConstraintView<Real>& constraints,
                     const ConstraintBatch<Real>& batch, std::size_t lane,
                     double mean_load_fraction, ContactPair& pair) {
  const double max_deviation = double{batch.max_deviation[lane]};
  const auto first = static_cast<std::size_t>(batch.first);
  bool is_loaded = false;
  for (std::size_t k = 0; k < pair.manifold.points().size(); ++k) {
    const ContactConstraintLanes<Real>& contact = constraints.contacts[first + k];
    const ContactColdLanes<Real>& cold = constraints.cold[first + k];
    const double load = double{contact.impulse[lane]};
    const double old = double{contact.mean_load[lane]};
    if (max_deviation > 0) {
      pair.mean_load[k] = old + mean_load_fraction *
                                    std::clamp(load - old, -max_deviation, max_deviation);
    } else if (cold.steady[lane] != 0 && cold.bounces[lane] == 0) {
      pair.mean_load[k] = load;
      is_loaded = is_loaded || load > 0;
    }
  }
  if (is_loaded) ++pair.loaded_steps;
}

template <class Real>
void StoreAll(const ConstraintView<Real>& constraints,
              const ContactParameters& parameters, std::span<ContactPair> pairs,
              ContactFlags* contact_flags) {
  using V = Vec<Real>;
  const V zero{};
  for (const ConstraintBatch<Real>& batch : constraints.batches) {
    std::array<ContactPair*, kLanes<Real>> pair{};
    std::array<int, kLanes<Real>> counts{};
    for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
      if (batch.pair[lane] < 0) continue;
      pair[lane] = &pairs[static_cast<std::size_t>(batch.pair[lane])];
      counts[lane] = pair[lane]->manifold.count;
      ScaleMeanLoads(parameters.h, *pair[lane]);
      if (parameters.yield > 0) {
        UpdateMeanLoads(constraints, batch, lane, parameters.mean_load_fraction,
                        *pair[lane]);
      }
    }
    VecBits<Real> bounced{};
    VecBits<Real> rested{};
    VecBits<Real> unsteady{};
    for (int k = 0; k < batch.count; ++k) {
      const auto index =
          static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k);
      const ContactConstraintLanes<Real>& contact = constraints.contacts[index];
      const ContactColdLanes<Real>& cold = constraints.cold[index];
      const V impulse = Load(contact.impulse);
      const Vec3<Real> J = ImpulseOf(batch, contact);
      VectorLanes<Real> J_W;
      Store(J.x, J_W[0]);
      Store(J.y, J_W[1]);
      Store(J.z, J_W[2]);
      for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
        if (k >= counts[lane]) continue;
        pair[lane]->J_W[static_cast<std::size_t>(k)] = {J_W[0][lane], J_W[1][lane],
                                                        J_W[2][lane]};
      }
      const VecBits<Real> acts = impulse > zero;
      const VecBits<Real> bounces = Load(cold.bounces) > zero;
      bounced |= acts & bounces;
      rested |= acts & ~bounces;
      unsteady |= acts & ~(Load(cold.steady) > zero);
    }
    const unsigned bounced_lanes = Bits(bounced);
    const unsigned rested_lanes = Bits(rested);
    const unsigned unsteady_lanes = Bits(unsteady);
    for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
      const auto update = [&](int body, double inverse_mass) {
        if (inverse_mass == 0) return;
        ContactFlags& flags = contact_flags[body];
        flags.bounced = flags.bounced || (bounced_lanes >> lane & 1) != 0;
        flags.rested = flags.rested || (rested_lanes >> lane & 1) != 0;
        flags.steady = flags.steady && (unsteady_lanes >> lane & 1) == 0;
      };
      update(batch.A[lane], batch.inverse_mass_A[lane]);
      update(batch.B[lane], batch.inverse_mass_B[lane]);
    }
  }
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
template <class Real>
void WarmStartContacts(const ConstraintView<Real>& constraints,
                       std::span<SolverVelocity<Real>> velocities) {
  COOKBOOK_DISPATCH(WarmStart<Real>)(constraints, velocities.data());
}
COOKBOOK_INSTANTIATE(WarmStartContacts);

void ApplyImpulsesInDouble(const ConstraintView<float>& constraints,
                           const SolverBodies& bodies) {
  COOKBOOK_DISPATCH(ApplyInDouble)(constraints, bodies);
}

template <class Real>
VelocityChanges SolveContacts(const ConstraintView<Real>& constraints,
                              const ContactParameters& parameters, double relaxation,
                              std::span<SolverVelocity<Real>> velocities) {
  return COOKBOOK_DISPATCH(SolveAll<Real>)(constraints, parameters, relaxation,
                                           velocities.data());
}
COOKBOOK_INSTANTIATE(SolveContacts);

template <class Real>
void StoreContactImpulses(const ConstraintView<Real>& constraints,
                          const ContactParameters& parameters,
                          std::span<ContactPair> pairs,
                          std::span<ContactFlags> contact_flags) {
  COOKBOOK_DISPATCH(StoreAll<Real>)
  (constraints, parameters, pairs, contact_flags.data());
}
COOKBOOK_INSTANTIATE(StoreContactImpulses);
}  // namespace cookbook
#endif
