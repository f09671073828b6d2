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
void ApplyAll(const ConstraintView<Real>& rows, SolverVelocity<Real>* velocities) {
  for (const ConstraintBatch<Real>& batch : rows.batches) {
    Moving<Real> A = Gather(velocities, batch.A);
    Moving<Real> B = Gather(velocities, batch.B);
    const Inertias<Real> m = InertiasOf<Real>(batch);
    const Vec3<Real> n = At(batch.n);
    const Vec3<Real> t1 = At(batch.t1);
    const Vec3<Real> t2 = At(batch.t2);
    const ContactLanes<Real>* rows_of_batch =
        &rows.contacts[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      const ContactLanes<Real>& contact = rows_of_batch[k];
      const Vec3<Real> J = Plus(Times(At(contact.impulse), n),
                                Plus(Times(At(contact.friction_impulse1), t1),
                                     Times(At(contact.friction_impulse2), t2)));
      Apply(J, At(contact.r_A), At(contact.r_B), m, A, B);
    }
    Scatter(A, batch.A, batch.inverse_mass_A, velocities);
    Scatter(B, batch.B, batch.inverse_mass_B, velocities);
  }
}

/** Returns the impulse of a contact on B. */
template <class Real>
HWY_INLINE Vec3<Real> ImpulseOf(const ConstraintBatch<Real>& batch,
                                const ContactLanes<Real>& contact) {
  return Plus(Plus(Times(At(contact.impulse), At(batch.n)),
                   Times(At(contact.friction_impulse1), At(batch.t1))),
              Times(At(contact.friction_impulse2), At(batch.t2)));
}

/** Applies the impulses of floats in double precision. */
void ApplyFound(const ConstraintView<float>& rows, const SolverBodies& world) {
  Velocity* velocities = world.velocities.data();
  alignas(64) static const InverseInertia kImmovable{};
  alignas(32) static constexpr std::array<double, 4> kAnywhere{};
  for (const ConstraintBatch<float>& batch : rows.batches) {
    const ContactLanes<float>* rows_of_batch =
        &rows.contacts[static_cast<std::size_t>(batch.first)];
    std::array<VectorLanes<float>, 8> J_W;
    for (int k = 0; k < batch.count; ++k) {
      const Vec3<float> J = ImpulseOf(batch, rows_of_batch[k]);
      VectorLanes<float>& lanes = J_W[static_cast<std::size_t>(k)];
      Put(J.x, lanes[0]);
      Put(J.y, lanes[1]);
      Put(J.z, lanes[2]);
    }
    for (std::size_t four = 0; four < kFours<float>; ++four) {
      const int* bodies_A = batch.A.data() + 4 * four;
      const int* bodies_B = batch.B.data() + 4 * four;
      const auto load = [&](const int* bodies, Tensor<double>& tensor,
                            Vec3<double>& centre) HWY_ATTR {
        std::array<const InverseInertia*, 4> inertia;
        std::array<const double*, 4> p_WB;
        for (std::size_t k = 0; k < 4; ++k) {
          const bool is_pair = batch.pair[4 * four + k] >= 0;
          const auto body = static_cast<std::size_t>(bodies[k]);
          inertia[k] = is_pair ? &world.inertias[body] : &kImmovable;
          p_WB[k] = is_pair ? world.bodies[body].state.p_WB.data() : kAnywhere.data();
        }
        Four lanes[4];
        LoadFour(p_WB, lanes);
        centre = {lanes[0], lanes[1], lanes[2]};
        return LoadInertias(inertia, tensor);
      };
      Inertias<double> m;
      Vec3<double> p_A;
      Vec3<double> p_B;
      m.mass_A = load(bodies_A, m.tensor_A, p_A);
      m.mass_B = load(bodies_B, m.tensor_B, p_B);
      const Vec3<double> p_AB = Minus(p_B, p_A);
      const FourBits A_moves = m.mass_A > Four{};
      Moving<double> A = GatherFour(velocities, bodies_A);
      Moving<double> B = GatherFour(velocities, bodies_B);
      Wrenches<double> all;
      for (int k = 0; k < batch.count; ++k) {
        const ContactLanes<float>& contact = rows_of_batch[k];
        const Vec3<double> J = FourAt(J_W[static_cast<std::size_t>(k)], four);
        // At the very same place of both, where both move: else they would turn for
        // nothing, by what two roundings of the place differ.
        const Vec3<double> r_A = FourAt(contact.r_A, four);
        const Vec3<double> seen = Minus(r_A, p_AB);
        const Vec3<double> own = FourAt(contact.r_B, four);
        const Vec3<double> r_B{Select(A_moves, seen.x, own.x),
                               Select(A_moves, seen.y, own.y),
                               Select(A_moves, seen.z, own.z)};
        all.Add(J, r_A, r_B);
      }
      Apply(all, m, A, B);
      ScatterFour(A, bodies_A, m.mass_A, velocities);
      ScatterFour(B, bodies_B, m.mass_B, velocities);
    }
  }
}

/** A batch while it is swept. */
template <class Real>
struct Solved {
  using V = Vec<Real>;
  static constexpr bool kMeasures = std::is_same_v<Real, double>;

  ConstraintBatch<Real>& batch;
  ContactLanes<Real>* rows;
  const ContactNotes<Real>* notes;
  Moving<Real> A;
  Moving<Real> B;
  Inertias<Real> m;
  Vec3<Real> n;
  Vec3<Real> t1;
  Vec3<Real> t2;
  V friction;
  V relaxation;
  V changed{};

  /** Returns `changed`, and +∞ in lanes without a pair. */
  HWY_INLINE V ChangedOfPairs() const {
    return Select(m.mass_A + m.mass_B > V{}, changed,
                  All<Real>(std::numeric_limits<Real>::infinity()));
  }
};

template <class Real>
HWY_INLINE Solved<Real> Begin(ConstraintBatch<Real>& batch,
                              const ConstraintView<Real>& rows, Vec<Real> relaxation,
                              const SolverVelocity<Real>* velocities) {
  const auto first = static_cast<std::size_t>(batch.first);
  return {batch,
          &rows.contacts[first],
          &rows.notes[first],
          Gather(velocities, batch.A),
          Gather(velocities, batch.B),
          InertiasOf<Real>(batch),
          At(batch.n),
          At(batch.t1),
          At(batch.t2),
          At(batch.friction),
          relaxation};
}

/** Of which kind all contacts of a world are. */
enum class Kind {
  kPlain,  ///< Hard, with impulses that accumulate.
  kAny,
};

/** Solves one contact of each pair, given 1 in `kept` where impulses accumulate. */
template <Kind kind, class Real>
HWY_INLINE void SolveRow(int row, Vec<Real> kept, Solved<Real>& at) {
  using V = Vec<Real>;
  ContactLanes<Real>& contact = at.rows[row];
  const V zero{};
  const Vec3<Real> r_A = At(contact.r_A);
  const Vec3<Real> r_B = At(contact.r_B);

  const Vec3<Real> u = RelativeVelocity(at.A, at.B, r_A, r_B);
  const V sum = At(contact.impulse);
  const V start = kind == Kind::kPlain ? sum : kept * sum;
  const V softened =
      kind == Kind::kPlain ? start : start - At(contact.impulse_scale) * sum;
  const V mass = at.relaxation * At(contact.effective_mass);
  const V impulse = Max(zero, softened + mass * (At(contact.target) - Dot(u, at.n)));
  const V change = impulse - start;
  Put(kind == Kind::kPlain ? impulse : sum + change, contact.impulse);

  V slip1 = Dot(u, at.t1) + change * At(contact.response_n1);
  V slip2 = Dot(u, at.t2) + change * At(contact.response_n2);
  if constexpr (std::is_same_v<Real, float>) {
    slip1 = slip1 + At(contact.slip1);
    slip2 = slip2 + At(contact.slip2);
  }
  const V bound = at.friction * impulse;
  const V bound_squared = bound * bound;
  const V sum1 = At(contact.friction_impulse1);
  const V sum2 = At(contact.friction_impulse2);
  const V held1 = kind == Kind::kPlain ? sum1 : kept * sum1;
  const V held2 = kind == Kind::kPlain ? sum2 : kept * sum2;
  // Inside the cone the impulse that stops the slip. Else a step against the slip,
  // brought back to the cone: where that stands still, the impulse is against the slip.
  const V stick12 = At(contact.stick12);
  const V stick1 = held1 - (At(contact.stick11) * slip1 + stick12 * slip2);
  const V stick2 = held2 - (stick12 * slip1 + At(contact.stick22) * slip2);
  V change1 = stick1 - held1;
  V change2 = stick2 - held2;
  const VecBits<Real> slides = stick1 * stick1 + stick2 * stick2 > bound_squared;
  // Most contacts hold: the branch is foretold, and spares a root and a quotient, which
  // the next row would wait for.
  if (Bits(slides) != 0) {
    const V step = At(contact.slip_step);
    const V slide1 = held1 - step * slip1;
    const V slide2 = held2 - step * slip2;
    const V length_squared = slide1 * slide1 + slide2 * slide2;
    const VecBits<Real> outside = length_squared > bound_squared;
    const V length = Sqrt(Select(outside, length_squared, All<Real>(1)));
    const V shrink = Select(outside, bound / length, All<Real>(1));
    change1 = Select(slides, shrink * slide1, stick1) - held1;
    change2 = Select(slides, shrink * slide2, stick2) - held2;
  }
  Put(sum1 + change1, contact.friction_impulse1);
  Put(sum2 + change2, contact.friction_impulse2);
  Apply(Plus(Times(change, at.n), Plus(Times(change1, at.t1), Times(change2, at.t2))),
        r_A, r_B, at.m, at.A, at.B);

  if constexpr (Solved<Real>::kMeasures) {
    const ContactNotes<Real>& note = at.notes[row];
    const V slip_response = At(note.slip_response);
    at.changed = Max(at.changed, Abs(change) * At(note.response));
    at.changed = Max(at.changed, Max(Abs(change1), Abs(change2)) * slip_response);
  }
}

template <class Real>
HWY_INLINE void End(const Solved<Real>& at, SolverVelocity<Real>* velocities) {
  if constexpr (Solved<Real>::kMeasures) Put(at.changed, at.batch.change);
  Scatter(at.A, at.batch.A, at.batch.inverse_mass_A, velocities);
  Scatter(at.B, at.batch.B, at.batch.inverse_mass_B, velocities);
}

template <Kind kind, class Real>
Changes SweepKind(const ConstraintView<Real>& rows, bool accumulated, double relaxation,
                  SolverVelocity<Real>* velocities) {
  using V = Vec<Real>;
  const V kept = All<Real>(accumulated ? 1 : 0);
  const V relaxed = All<Real>(relaxation);
  V greatest{};
  V least = All<Real>(std::numeric_limits<Real>::infinity());
  const std::size_t count = rows.batches.size();
  const auto next_at_work = [&](std::size_t k) {
    while (k < count && !rows.batches[k].at_work) ++k;
    return k;
  };
  // Two batches at once, row by row: each row of a batch waits for the one before it, and
  // no batch of a colour for another.
  for (std::size_t k = next_at_work(0); k < count;) {
    const std::size_t second = next_at_work(k + 1);
    Solved<Real> one = Begin<Real>(rows.batches[k], rows, relaxed, velocities);
    if (second == count) {
      for (int i = 0; i < one.batch.count; ++i) SolveRow<kind, Real>(i, kept, one);
      End(one, velocities);
      greatest = Max(greatest, one.changed);
      least = Min(least, one.ChangedOfPairs());
      break;
    }
    Solved<Real> two = Begin<Real>(rows.batches[second], rows, relaxed, velocities);
    const int both = std::min(one.batch.count, two.batch.count);
    for (int i = 0; i < both; ++i) {
      SolveRow<kind, Real>(i, kept, one);
      SolveRow<kind, Real>(i, kept, two);
    }
    for (int i = both; i < one.batch.count; ++i) SolveRow<kind, Real>(i, kept, one);
    for (int i = both; i < two.batch.count; ++i) SolveRow<kind, Real>(i, kept, two);
    End(one, velocities);
    End(two, velocities);
    greatest = Max(greatest, Max(one.changed, two.changed));
    least = Min(least, Min(one.ChangedOfPairs(), two.ChangedOfPairs()));
    k = next_at_work(second + 1);
  }
  if constexpr (Solved<Real>::kMeasures) {
    return {Greatest(greatest), -Greatest(-least)};
  } else {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    return {kUnknown, kUnknown};
  }
}

template <class Real>
Changes Iterate(const ConstraintView<Real>& rows, const ContactRules& rules,
                double relaxation, SolverVelocity<Real>* velocities) {
  const bool is_plain = rules.accumulated && rules.soft_impulse_scale == 0;
  return (is_plain ? SweepKind<Kind::kPlain, Real>
                   : SweepKind<Kind::kAny, Real>)(rows, rules.accumulated, relaxation,
                                                  velocities);
}

template <class Real>
void Read(const ConstraintView<Real>& rows, std::span<ContactPair> pairs,
          Touch* touches) {
  using V = Vec<Real>;
  const V zero{};
  for (const ConstraintBatch<Real>& batch : rows.batches) {
    std::array<ContactPair*, kLanes<Real>> pair{};
    std::array<int, kLanes<Real>> counts{};
    for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
      if (batch.pair[lane] < 0) continue;
      pair[lane] = &pairs[static_cast<std::size_t>(batch.pair[lane])];
      counts[lane] = pair[lane]->manifold.count;
    }
    VecBits<Real> bounced{};
    VecBits<Real> rested{};
    VecBits<Real> unsteady{};
    for (int k = 0; k < batch.count; ++k) {
      const auto row =
          static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k);
      const ContactLanes<Real>& contact = rows.contacts[row];
      const ContactNotes<Real>& note = rows.notes[row];
      const V impulse = At(contact.impulse);
      const Vec3<Real> J = ImpulseOf(batch, contact);
      VectorLanes<Real> J_W;
      Put(J.x, J_W[0]);
      Put(J.y, J_W[1]);
      Put(J.z, J_W[2]);
      for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
        if (k >= counts[lane]) continue;
        pair[lane]->J_W[static_cast<std::size_t>(k)] = {J_W[0][lane], J_W[1][lane],
                                                        J_W[2][lane]};
      }
      const VecBits<Real> acts = impulse > zero;
      const VecBits<Real> bounces = At(note.bounces) > zero;
      bounced |= acts & bounces;
      rested |= acts & ~bounces;
      unsteady |= acts & ~(At(note.steady) > zero);
    }
    const unsigned who_bounced = Bits(bounced);
    const unsigned who_rested = Bits(rested);
    const unsigned who_is_unsteady = Bits(unsteady);
    for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
      const auto note = [&](int body, double inverse_mass) {
        if (inverse_mass == 0) return;
        Touch& touch = touches[body];
        touch.bounced = touch.bounced || (who_bounced >> lane & 1) != 0;
        touch.rested = touch.rested || (who_rested >> lane & 1) != 0;
        touch.steady = touch.steady && (who_is_unsteady >> lane & 1) == 0;
      };
      note(batch.A[lane], batch.inverse_mass_A[lane]);
      note(batch.B[lane], batch.inverse_mass_B[lane]);
    }
  }
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
template <class Real>
void ApplyImpulses(const ConstraintView<Real>& rows,
                   std::span<SolverVelocity<Real>> velocities) {
  COOKBOOK_DISPATCH(ApplyAll<Real>)(rows, velocities.data());
}
COOKBOOK_INSTANTIATE(ApplyImpulses);

void ApplyFoundImpulses(const ConstraintView<float>& rows, const SolverBodies& world) {
  COOKBOOK_DISPATCH(ApplyFound)(rows, world);
}

template <class Real>
Changes SolveContacts(const ConstraintView<Real>& rows, const ContactRules& rules,
                      double relaxation, std::span<SolverVelocity<Real>> velocities) {
  return COOKBOOK_DISPATCH(Iterate<Real>)(rows, rules, relaxation, velocities.data());
}
COOKBOOK_INSTANTIATE(SolveContacts);

template <class Real>
void ReadContacts(const ConstraintView<Real>& rows, std::span<ContactPair> pairs,
                  std::span<Touch> touches) {
  COOKBOOK_DISPATCH(Read<Real>)(rows, pairs, touches.data());
}
COOKBOOK_INSTANTIATE(ReadContacts);
}  // namespace cookbook
#endif
