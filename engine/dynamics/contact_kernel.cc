#include <algorithm>
#include <limits>

#include "engine/dynamics/contact_batch.h"

// Four lanes are one register from AVX2 on; wider ones would add nothing.
#define HWY_DISABLED_TARGETS                                                          \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dynamics/contact_kernel.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "engine/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

/** A contact that approaches slower than this share of what gravity adds in a step is one
 that was there all along. */
constexpr double kSteady = 1.0 / 16;

struct Four3 {
  Four x;
  Four y;
  Four z;
};

HWY_INLINE Four At(const Lanes& lanes) {
  return Load(lanes.data());
}
HWY_INLINE Four3 At(const VectorLanes& lanes) {
  return {At(lanes[0]), At(lanes[1]), At(lanes[2])};
}
HWY_INLINE void Put(Four v, Lanes& lanes) {
  Store(v, lanes.data());
}

HWY_INLINE Four Dot(const Four3& a, const Four3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Four3 Cross(const Four3& a, const Four3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Four3 Plus(const Four3& a, const Four3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Four3 Minus(const Four3& a, const Four3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Four3 Times(Four s, const Four3& a) {
  return {s * a.x, s * a.y, s * a.z};
}

struct Tensor {
  Four xx, xy, xz, yy, yz, zz;
};
HWY_INLINE Tensor At(const TensorLanes& lanes) {
  return {At(lanes[0]), At(lanes[1]), At(lanes[2]),
          At(lanes[3]), At(lanes[4]), At(lanes[5])};
}
HWY_INLINE Four3 Times(const Tensor& t, const Four3& a) {
  return {t.xx * a.x + t.xy * a.y + t.xz * a.z, t.xy * a.x + t.yy * a.y + t.yz * a.z,
          t.xz * a.x + t.yz * a.y + t.zz * a.z};
}

/** The velocities of four bodies. */
struct Moving {
  Four3 v;
  Four3 w;
};

HWY_INLINE void Transpose4(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

HWY_INLINE Moving Gather(const Velocity* velocities, const std::array<int, 4>& bodies) {
  Four low[4];
  Four high[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const double* numbers = velocities[bodies[k]].v.data();
    low[k] = Load(numbers);
    high[k] = Load(numbers + 4);
  }
  Transpose4(low[0], low[1], low[2], low[3]);
  Transpose4(high[0], high[1], high[2], high[3]);
  return {{low[0], low[1], low[2]}, {low[3], high[0], high[1]}};
}

/** Writes the velocities of those that move: several threads may read one that does not.
 */
HWY_INLINE void Scatter(const Moving& moving, const std::array<int, 4>& bodies,
                        const Lanes& inverse_mass, Velocity* velocities) {
  Four low[4] = {moving.v.x, moving.v.y, moving.v.z, moving.w.x};
  Four high[4] = {moving.w.y, moving.w.z, Four{}, Four{}};
  Transpose4(low[0], low[1], low[2], low[3]);
  Transpose4(high[0], high[1], high[2], high[3]);
  for (std::size_t k = 0; k < 4; ++k) {
    if (inverse_mass[k] == 0) continue;
    double* numbers = velocities[bodies[k]].v.data();
    Store(low[k], numbers);
    Store(high[k], numbers + 4);
  }
}

HWY_INLINE Four3 RelativeVelocity(const Moving& A, const Moving& B, const Four3& r_A,
                                  const Four3& r_B) {
  return Minus(Plus(B.v, Cross(B.w, r_B)), Plus(A.v, Cross(A.w, r_A)));
}

/** What resists the impulses of a batch. */
struct Inertias {
  Four mass_A;
  Four mass_B;
  Tensor tensor_A;
  Tensor tensor_B;
};

HWY_INLINE Inertias InertiasOf(const ContactBatch& batch) {
  return {At(batch.inverse_mass_A), At(batch.inverse_mass_B), At(batch.inverse_inertia_A),
          At(batch.inverse_inertia_B)};
}

/** Applies J to B and −J to A. */
HWY_INLINE void Apply(const Four3& J, const Four3& r_A, const Four3& r_B,
                      const Inertias& m, Moving& A, Moving& B) {
  A.v = Minus(A.v, Times(m.mass_A, J));
  A.w = Minus(A.w, Times(m.tensor_A, Cross(r_A, J)));
  B.v = Plus(B.v, Times(m.mass_B, J));
  B.w = Plus(B.w, Times(m.tensor_B, Cross(r_B, J)));
}

HWY_INLINE double Greatest(Four v) {
  return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}

double Prepare(const ContactRows& rows, const ContactRules& rules, const Velocity* before,
               const Velocity* velocities) {
  const Four zero{};
  const Four one = Splat(1);
  Four greatest{};
  for (const ContactBatch& batch : rows.batches) {
    const Moving A_before = Gather(before, batch.A);
    const Moving B_before = Gather(before, batch.B);
    const Moving A_free = Gather(velocities, batch.A);
    const Moving B_free = Gather(velocities, batch.B);
    const Inertias m = InertiasOf(batch);
    const Four3 n = At(batch.n);
    const Four3 t1 = At(batch.t1);
    const Four3 t2 = At(batch.t2);
    const Four restitution = At(batch.restitution);
    for (int k = 0; k < batch.count; ++k) {
      ContactLanes& contact = rows.contacts[static_cast<std::size_t>(batch.first + k)];
      const Four3 r_A = At(contact.r_A);
      const Four3 r_B = At(contact.r_B);
      const FourBits used = At(contact.used) > zero;
      const Four3 u_before = RelativeVelocity(A_before, B_before, r_A, r_B);
      const Four3 u_free = RelativeVelocity(A_free, B_free, r_A, r_B);
      greatest =
          Max(greatest,
              Select(used, Max(Dot(u_before, u_before), Dot(u_free, u_free)), zero));
      const Four approach = Dot(u_before, n);
      const Four pull = Dot(u_free, n) - approach;
      const Four usual = Splat(rules.gravity_speed) + Abs(pull);
      const Four sent_back = pull - restitution * approach;
      const FourBits apart = At(contact.separation) > zero;
      const Four fast = Splat(rules.resting_speed) * usual;
      const FourBits would_bounce = (approach < zero - fast) & (sent_back > zero);
      // What parts, and meets a blow of this step, comes back by the same law: held at
      // rest it would leave the other body of the blow with the energy of both.
      const FourBits leaves = restitution * approach > fast;
      const FourBits bounces = leaves | (would_bounce & ~apart);
      const FourBits steady = Abs(approach) <= Splat(kSteady) * usual;

      // Not there yet: what will bounce goes on, what will rest arrives with the step.
      const Four arrive =
          Select(would_bounce, Splat(-std::numeric_limits<double>::infinity()),
                 zero - At(contact.separation) / Splat(rules.h));
      const Four excess = zero - At(contact.separation) - Splat(rules.slack);
      const FourBits deep = (excess > zero) & ~would_bounce;
      const Four push =
          Select(deep, Splat(rules.baumgarte + rules.soft_rate) * excess, zero);
      const Four least =
          Select(leaves, sent_back, Min(zero, zero - restitution * approach));
      const Four target = Select(apart, Min(arrive, least),
                                 Select(would_bounce, sent_back, push + least));

      const Four3 a_n = Cross(r_A, n);
      const Four3 b_n = Cross(r_B, n);
      const Four3 a_1 = Cross(r_A, t1);
      const Four3 b_1 = Cross(r_B, t1);
      const Four3 a_2 = Cross(r_A, t2);
      const Four3 b_2 = Cross(r_B, t2);
      const Four3 Ia_1 = Times(m.tensor_A, a_1);
      const Four3 Ib_1 = Times(m.tensor_B, b_1);
      const Four mass = m.mass_A + m.mass_B;
      const Four3 Ia_n = Times(m.tensor_A, a_n);
      const Four3 Ib_n = Times(m.tensor_B, b_n);
      const Four k_n = mass + Dot(a_n, Ia_n) + Dot(b_n, Ib_n);
      const Four k_n1 = Dot(a_1, Ia_n) + Dot(b_1, Ib_n);
      const Four k_n2 = Dot(a_2, Ia_n) + Dot(b_2, Ib_n);
      const Four k11 = mass + Dot(a_1, Ia_1) + Dot(b_1, Ib_1);
      const Four k12 = Dot(a_2, Ia_1) + Dot(b_2, Ib_1);
      const Four k22 =
          mass + Dot(a_2, Times(m.tensor_A, a_2)) + Dot(b_2, Times(m.tensor_B, b_2));
      const Four determinant = k11 * k22 - k12 * k12;
      const Four difference = k11 - k22;
      const Four k_slip =
          Splat(0.5) * (k11 + k22 + Sqrt(difference * difference + Splat(4) * k12 * k12));
      const Four soft = Select(deep, Splat(rules.soft_mass_scale), one);
      const Four scale = Select(deep, Splat(rules.soft_impulse_scale), zero);
      Put(Select(used, target, zero), contact.target);
      Put(Select(used, k_n, zero), contact.response);
      Put(Select(used, soft / k_n, zero), contact.effective_mass);
      Put(Select(used, scale, zero), contact.impulse_scale);
      Put(k_n1, contact.response_n1);
      Put(k_n2, contact.response_n2);
      Put(Select(used, k22 / determinant, zero), contact.stick11);
      Put(Select(used, zero - k12 / determinant, zero), contact.stick12);
      Put(Select(used, k11 / determinant, zero), contact.stick22);
      Put(Select(used, k_slip, zero), contact.slip_response);
      Put(Select(used, one / k_slip, zero), contact.slip_step);
      Put(Select(bounces & used, one, zero), contact.bounces);
      Put(Select(steady, one, zero), contact.steady);
    }
  }
  return Greatest(Sqrt(greatest));
}

void ApplyAll(const ContactRows& rows, Velocity* velocities) {
  for (const ContactBatch& batch : rows.batches) {
    Moving A = Gather(velocities, batch.A);
    Moving B = Gather(velocities, batch.B);
    const Inertias m = InertiasOf(batch);
    const Four3 n = At(batch.n);
    const Four3 t1 = At(batch.t1);
    const Four3 t2 = At(batch.t2);
    for (int k = 0; k < batch.count; ++k) {
      const ContactLanes& contact =
          rows.contacts[static_cast<std::size_t>(batch.first + k)];
      const Four3 J = Plus(Times(At(contact.impulse), n),
                           Plus(Times(At(contact.friction_impulse1), t1),
                                Times(At(contact.friction_impulse2), t2)));
      Apply(J, At(contact.r_A), At(contact.r_B), m, A, B);
    }
    Scatter(A, batch.A, batch.inverse_mass_A, velocities);
    Scatter(B, batch.B, batch.inverse_mass_B, velocities);
  }
}

/** A batch while it is swept. */
struct Swept {
  ContactBatch& batch;
  ContactLanes* rows;
  Moving A;
  Moving B;
  Inertias m;
  Four3 n;
  Four3 t1;
  Four3 t2;
  Four friction;
  Four changed{};

  /** Returns `changed`, and +∞ in lanes without a pair. */
  HWY_INLINE Four ChangedOfPairs() const {
    return Select(m.mass_A + m.mass_B > Four{}, changed,
                  Splat(std::numeric_limits<double>::infinity()));
  }
};

HWY_INLINE Swept Begin(ContactBatch& batch, const ContactRows& rows,
                       const Velocity* velocities) {
  return {batch,
          &rows.contacts[static_cast<std::size_t>(batch.first)],
          Gather(velocities, batch.A),
          Gather(velocities, batch.B),
          InertiasOf(batch),
          At(batch.n),
          At(batch.t1),
          At(batch.t2),
          At(batch.friction)};
}

/** Solves one contact of each pair, given 1 in `kept` where impulses are accumulated. */
HWY_INLINE void SolveRow(ContactLanes& contact, Four kept, Swept& at) {
  const Four zero{};
  const Four3 r_A = At(contact.r_A);
  const Four3 r_B = At(contact.r_B);

  const Four3 u = RelativeVelocity(at.A, at.B, r_A, r_B);
  const Four sum = At(contact.impulse);
  const Four start = kept * sum;
  const Four impulse =
      Max(zero, start + At(contact.effective_mass) * (At(contact.target) - Dot(u, at.n)) -
                    At(contact.impulse_scale) * sum);
  const Four change = impulse - start;
  Put(sum + change, contact.impulse);

  const Four slip1 = Dot(u, at.t1) + change * At(contact.response_n1);
  const Four slip2 = Dot(u, at.t2) + change * At(contact.response_n2);
  const Four bound = at.friction * impulse;
  const Four bound_squared = bound * bound;
  const Four sum1 = At(contact.friction_impulse1);
  const Four sum2 = At(contact.friction_impulse2);
  const Four held1 = kept * sum1;
  const Four held2 = kept * sum2;
  // Inside the cone the impulse that stops the slip. Else a step against the slip,
  // brought back to the cone: where that stands still, the impulse is against the slip.
  const Four stick12 = At(contact.stick12);
  const Four stick1 = held1 - (At(contact.stick11) * slip1 + stick12 * slip2);
  const Four stick2 = held2 - (stick12 * slip1 + At(contact.stick22) * slip2);
  Four change1 = stick1 - held1;
  Four change2 = stick2 - held2;
  const FourBits slides = stick1 * stick1 + stick2 * stick2 > bound_squared;
  // Most contacts hold: the branch is foretold, and spares a root and a quotient, which
  // the next row would wait for.
  if (Bits(slides) != 0) {
    const Four step = At(contact.slip_step);
    const Four slide1 = held1 - step * slip1;
    const Four slide2 = held2 - step * slip2;
    const Four length_squared = slide1 * slide1 + slide2 * slide2;
    const FourBits outside = length_squared > bound_squared;
    const Four length = Sqrt(Select(outside, length_squared, Splat(1)));
    const Four shrink = Select(outside, bound / length, Splat(1));
    change1 = Select(slides, shrink * slide1, stick1) - held1;
    change2 = Select(slides, shrink * slide2, stick2) - held2;
  }
  Put(sum1 + change1, contact.friction_impulse1);
  Put(sum2 + change2, contact.friction_impulse2);
  Apply(Plus(Times(change, at.n), Plus(Times(change1, at.t1), Times(change2, at.t2))),
        r_A, r_B, at.m, at.A, at.B);

  const Four slip_response = At(contact.slip_response);
  at.changed = Max(at.changed, Abs(change) * At(contact.response));
  at.changed = Max(at.changed, Max(Abs(change1), Abs(change2)) * slip_response);
}

HWY_INLINE void End(const Swept& at, Velocity* velocities) {
  Put(at.changed, at.batch.change);
  Scatter(at.A, at.batch.A, at.batch.inverse_mass_A, velocities);
  Scatter(at.B, at.batch.B, at.batch.inverse_mass_B, velocities);
}

Changes Sweep(const ContactRows& rows, bool accumulated, Velocity* velocities) {
  const Four kept = Splat(accumulated ? 1 : 0);
  Four greatest{};
  Four least = Splat(std::numeric_limits<double>::infinity());
  const std::size_t count = rows.batches.size();
  const auto next_at_work = [&](std::size_t k) {
    while (k < count && !rows.batches[k].at_work) ++k;
    return k;
  };
  // Two batches at once, row by row: each row of a batch waits for the one before it, and
  // no batch of a colour for another.
  for (std::size_t k = next_at_work(0); k < count;) {
    const std::size_t second = next_at_work(k + 1);
    Swept one = Begin(rows.batches[k], rows, velocities);
    if (second == count) {
      for (int i = 0; i < one.batch.count; ++i) SolveRow(one.rows[i], kept, one);
      End(one, velocities);
      greatest = Max(greatest, one.changed);
      least = Min(least, one.ChangedOfPairs());
      break;
    }
    Swept two = Begin(rows.batches[second], rows, velocities);
    const int both = std::min(one.batch.count, two.batch.count);
    for (int i = 0; i < both; ++i) {
      SolveRow(one.rows[i], kept, one);
      SolveRow(two.rows[i], kept, two);
    }
    for (int i = both; i < one.batch.count; ++i) SolveRow(one.rows[i], kept, one);
    for (int i = both; i < two.batch.count; ++i) SolveRow(two.rows[i], kept, two);
    End(one, velocities);
    End(two, velocities);
    greatest = Max(greatest, Max(one.changed, two.changed));
    least = Min(least, Min(one.ChangedOfPairs(), two.ChangedOfPairs()));
    k = next_at_work(second + 1);
  }
  return {Greatest(greatest), -Greatest(-least)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(Prepare);
HWY_EXPORT(ApplyAll);
HWY_EXPORT(Sweep);

double PrepareContacts(const ContactRows& rows, const ContactRules& rules,
                       std::span<const Velocity> before,
                       std::span<const Velocity> velocities) {
  return HWY_DYNAMIC_DISPATCH(Prepare)(rows, rules, before.data(), velocities.data());
}

void ApplyImpulses(const ContactRows& rows, std::span<Velocity> velocities) {
  HWY_DYNAMIC_DISPATCH(ApplyAll)(rows, velocities.data());
}

Changes SweepContacts(const ContactRows& rows, bool accumulated,
                      std::span<Velocity> velocities) {
  return HWY_DYNAMIC_DISPATCH(Sweep)(rows, accumulated, velocities.data());
}
}  // namespace cookbook
#endif
