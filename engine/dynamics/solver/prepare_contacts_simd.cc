#include <algorithm>
#include <limits>
#include <span>

#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/threads/prefetch.h"

#define HWY_TARGET_INCLUDE "engine/dynamics/solver/prepare_contacts_simd.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/dynamics/solver/solver_bodies_simd.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

/** A contact that approaches slower than this share of what gravity adds in a step is one
 that was there all along. */
constexpr double kSteady = 1.0 / 16;

/** By how much a sum may be off, as a share of itself. */
template <class Real>
constexpr double kRounding = std::is_same_v<Real, float> ? 1e-6 : 1e-14;
/** A face narrower than the root of this share of its length is a line: a load spread
 across it would be off by some roundings over this share. */
template <class Real>
constexpr double kLine = std::is_same_v<Real, float> ? 1e-3 : 1e-12;

/** Returns where a contact is, from a body of its pair: in single precision from the
 nearer one, since a wide ground rounds what it is apart from others. */
template <class Real>
HWY_INLINE Vec3<Real> PlaceOf(const ContactLanes<Real>& first,
                              const ContactLanes<Real>& contact) {
  const Vec3<Real> r_A = At(contact.r_A);
  if constexpr (std::is_same_v<Real, double>) {
    return r_A;
  } else {
    const Vec3<Real> A = At(first.r_A);
    const Vec3<Real> B = At(first.r_B);
    const VecBits<Real> nearer = Dot(B, B) < Dot(A, A);
    const Vec3<Real> r_B = At(contact.r_B);
    return {Select(nearer, r_B.x, r_A.x), Select(nearer, r_B.y, r_A.y),
            Select(nearer, r_B.z, r_A.z)};
  }
}

/** Returns a unit vector across the unit vector n, as Eigen's unitOrthogonal(). */
HWY_INLINE Vec3<double> Across(const Vec3<double>& n) {
  const Four zero{};
  const Four small = Splat(1e-12) * Abs(n.z);
  const FourBits level = (Abs(n.x) > small) | (Abs(n.y) > small);
  const Four a = Select(level, n.x, n.y);
  const Four b = Select(level, n.y, n.z);
  const Four scale = Splat(1) / Sqrt(a * a + b * b);
  const Four along_a = (zero - b) * scale;
  const Four along_b = a * scale;
  return {Select(level, along_a, zero), Select(level, along_b, along_a),
          Select(level, zero, along_b)};
}

/** Spreads the impulses along the normal as a stiff even bed would carry the same load:
 linear in the place, of the same sum and the same moments. Four contacts or more hold a
 face in more ways than one, and which of them sweeps find, and carry on from step to
 step, hangs on their order; how a face slides hangs on the way.

 λ' = λ̄ + g·(x − x̄), g the least squares of λ − λ̄: of all λ of these sums the one of least
 Σ λ². Left alone where a contact carries nothing, or would load. */
template <class Real>
HWY_INLINE void SpreadLoad(const ConstraintBatch<Real>& batch, ContactLanes<Real>* rows,
                           const ContactNotes<Real>* notes) {
  using V = Vec<Real>;
  const V zero{};
  const V most = All<Real>(std::numeric_limits<Real>::max());
  V number{};
  V load{};
  V lowest = most;
  Vec3<Real> centre{};
  for (int k = 0; k < batch.count; ++k) {
    const V used = At(notes[k].used);
    const V impulse = At(rows[k].impulse);
    number = number + used;
    load = load + impulse;
    lowest = Select(used > zero, Min(lowest, impulse), lowest);
    centre = Plus(centre, Times(used, PlaceOf(rows[0], rows[k])));
  }
  VecBits<Real> spreads = (number > All<Real>(3.5)) & (lowest > zero);
  if (Bits(spreads) == 0) return;
  const V share = All<Real>(1) / Max(number, All<Real>(1));
  const V mean = load * share;
  centre = Times(share, centre);
  const Vec3<Real> t1 = At(batch.t1);
  const Vec3<Real> t2 = At(batch.t2);
  V x[8];
  V y[8];
  V xx{};
  V xy{};
  V yy{};
  V moment_x{};
  V moment_y{};
  for (int k = 0; k < batch.count; ++k) {
    const Vec3<Real> arm =
        Times(At(notes[k].used), Minus(PlaceOf(rows[0], rows[k]), centre));
    x[k] = Dot(arm, t1);
    y[k] = Dot(arm, t2);
    xx = xx + x[k] * x[k];
    xy = xy + x[k] * y[k];
    yy = yy + y[k] * y[k];
    const V more = At(rows[k].impulse) - mean;
    moment_x = moment_x + more * x[k];
    moment_y = moment_y + more * y[k];
  }
  // Contacts on a line have no gradient across it.
  const V determinant = xx * yy - xy * xy;
  const V trace = xx + yy;
  spreads &= determinant > All<Real>(kLine<Real>) * trace * trace;
  const V per = All<Real>(1) / Select(spreads, determinant, All<Real>(1));
  const V gradient_x = per * (yy * moment_x - xy * moment_y);
  const V gradient_y = per * (xx * moment_y - xy * moment_x);
  V even[8];
  V lowest_even = most;
  for (int k = 0; k < batch.count; ++k) {
    even[k] = mean + gradient_x * x[k] + gradient_y * y[k];
    lowest_even =
        Select(At(notes[k].used) > zero, Min(lowest_even, even[k]), lowest_even);
  }
  spreads &= lowest_even > zero;
  for (int k = 0; k < batch.count; ++k) {
    const VecBits<Real> changes = spreads & (At(notes[k].used) > zero);
    Put(Select(changes, even[k], At(rows[k].impulse)), rows[k].impulse);
  }
}

/** Spreads the impulses of friction of a face that holds as the load is spread: of all
 that have the same sum and the same moment about the normal those of least Σ f²/λ, with
 which every contact is as far from its bound as the face is, if it does not spin. Else
 contacts load against each other across the face, by what the first sweeps left there,
 and slip too early.

 f' = λ (F/Σλ + s × (x − x̄)), x̄ the centre of the load, s = M / Σ λ (x − x̄)². Left alone
 where a contact slips, since its friction then follows from that, or where f' is beyond
 the cone. */
template <class Real>
HWY_INLINE void SpreadFriction(const ConstraintBatch<Real>& batch,
                               ContactLanes<Real>* rows, const ContactNotes<Real>* notes,
                               const Pairs<Real>& before, const Pairs<Real>& free) {
  using V = Vec<Real>;
  const V zero{};
  const V one = All<Real>(1);
  const Vec3<Real> n = At(batch.n);
  const Vec3<Real> t1 = At(batch.t1);
  const Vec3<Real> t2 = At(batch.t2);
  V number{};
  V load{};
  V sum1{};
  V sum2{};
  VecBits<Real> slips = zero > zero;
  Vec3<Real> centre{};
  for (int k = 0; k < batch.count; ++k) {
    const V impulse = At(rows[k].impulse);
    const Vec3<Real> r_A = At(rows[k].r_A);
    number = number + Select(impulse > zero, one, zero);
    load = load + impulse;
    sum1 = sum1 + At(rows[k].friction_impulse1);
    sum2 = sum2 + At(rows[k].friction_impulse2);
    centre = Plus(centre, Times(impulse, PlaceOf(rows[0], rows[k])));
    const Vec3<Real> r_B = At(rows[k].r_B);
    const Vec3<Real> u = before.At(r_A, r_B);
    const V slip1 = Dot(u, t1);
    const V slip2 = Dot(u, t2);
    const V gain = Dot(Minus(free.At(r_A, r_B), u), n);
    const V steady = All<Real>(kSteady) * (At(batch.usual) + Abs(gain));
    slips |= (impulse > zero) & (slip1 * slip1 + slip2 * slip2 > steady * steady);
  }
  VecBits<Real> spreads = (number > All<Real>(1.5)) & ~slips;
  if (Bits(spreads) == 0) return;
  const V share = one / Select(spreads, load, one);
  centre = Times(share, centre);
  V x[8];
  V y[8];
  V moment{};
  V polar{};
  for (int k = 0; k < batch.count; ++k) {
    const Vec3<Real> arm = Minus(PlaceOf(rows[0], rows[k]), centre);
    x[k] = Dot(arm, t1);
    y[k] = Dot(arm, t2);
    moment = moment + x[k] * At(rows[k].friction_impulse2) -
             y[k] * At(rows[k].friction_impulse1);
    polar = polar + At(rows[k].impulse) * (x[k] * x[k] + y[k] * y[k]);
  }
  const V spin = Select(polar > zero, moment, zero) / Select(polar > zero, polar, one);
  const V mean1 = share * sum1;
  const V mean2 = share * sum2;
  // The sum of what is at its bound may round to beyond it.
  const V bound =
      At(batch.friction) * At(batch.friction) * All<Real>(1 + kRounding<Real>);
  for (int k = 0; k < batch.count; ++k) {
    const V along1 = mean1 - spin * y[k];
    const V along2 = mean2 + spin * x[k];
    const VecBits<Real> inside = along1 * along1 + along2 * along2 <= bound;
    spreads &= inside | ~(At(rows[k].impulse) > zero);
  }
  for (int k = 0; k < batch.count; ++k) {
    const VecBits<Real> changes = spreads & (At(notes[k].used) > zero);
    const V impulse = At(rows[k].impulse);
    Put(Select(changes, impulse * (mean1 - spin * y[k]), At(rows[k].friction_impulse1)),
        rows[k].friction_impulse1);
    Put(Select(changes, impulse * (mean2 + spin * x[k]), At(rows[k].friction_impulse2)),
        rows[k].friction_impulse2);
  }
}

/** Fills what a batch and its rows have of the pairs. */
template <class Real>
HWY_INLINE void Fill(ConstraintBatch<Real>& batch, ContactLanes<Real>* rows,
                     ContactNotes<Real>* notes, const ContactRules& rules,
                     std::span<const ContactPair> pairs, const SolverBodies& world) {
  static_assert(offsetof(ContactPoint, separation) == sizeof(Eigen::Vector3d));
  // Of a lane without a pair, and of what a pair has fewer of than another.
  alignas(32) constexpr std::array<double, 4> kNothing = {0, 0, 0, 0};
  alignas(32) constexpr std::array<double, 4> kAnyNormal = {1, 0, 0, 0};
  alignas(64) static const InverseInertia kImmovable{};
  for (std::size_t four = 0; four < kFours<Real>; ++four) {
    std::array<const ContactPair*, 4> pair;
    std::array<int, 4> counts;
    std::array<const double*, 4> n_AB;
    std::array<const double*, 4> x_A;
    std::array<const double*, 4> x_B;
    std::array<const InverseInertia*, 4> inertia_A;
    std::array<const InverseInertia*, 4> inertia_B;
    alignas(32) Lanes<double> friction;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t lane = 4 * four + k;
      const bool is_pair = batch.pair[lane] >= 0;
      pair[k] = is_pair ? &pairs[static_cast<std::size_t>(batch.pair[lane])] : nullptr;
      counts[k] = is_pair ? pair[k]->manifold.count : 0;
      n_AB[k] = is_pair ? pair[k]->manifold.n_AB_W.data() : kAnyNormal.data();
      x_A[k] = x_B[k] = kNothing.data();
      inertia_A[k] = inertia_B[k] = &kImmovable;
      friction[k] = 0;
      batch.restitution[lane] = batch.usual[lane] = batch.slop[lane] = 0;
      if (!is_pair) continue;
      const auto a = static_cast<std::size_t>(batch.A[lane]);
      const auto b = static_cast<std::size_t>(batch.B[lane]);
      const RigidBody& A = world.bodies[a];
      const RigidBody& B = world.bodies[b];
      x_A[k] = A.state.p_WB.data();
      x_B[k] = B.state.p_WB.data();
      inertia_A[k] = &world.inertias[a];
      inertia_B[k] = &world.inertias[b];
      friction[k] = A.friction * B.friction;
      batch.restitution[lane] = static_cast<Real>(std::min(A.restitution, B.restitution));
      batch.usual[lane] = static_cast<Real>(rules.h * LoadAccelerationOn(*pair[k], A, B));
      batch.slop[lane] = static_cast<Real>(SlopBetween(A, B));
    }
    const auto put_inertias = [&](const std::array<const InverseInertia*, 4>& from,
                                  Lanes<Real>& mass, TensorLanes<Real>& tensor) HWY_ATTR {
      Tensor<double> t;
      PutFour(LoadInertias(from, t), four, mass);
      PutFour(t.xx, four, tensor[0]);
      PutFour(t.xy, four, tensor[1]);
      PutFour(t.xz, four, tensor[2]);
      PutFour(t.yy, four, tensor[3]);
      PutFour(t.yz, four, tensor[4]);
      PutFour(t.zz, four, tensor[5]);
    };
    put_inertias(inertia_A, batch.inverse_mass_A, batch.inverse_inertia_A);
    put_inertias(inertia_B, batch.inverse_mass_B, batch.inverse_inertia_B);
    PutFour(Sqrt(At(friction)), four, batch.friction);
    Four lanes[4];
    LoadFour(x_A, lanes);
    const Vec3<double> centre_A{lanes[0], lanes[1], lanes[2]};
    LoadFour(x_B, lanes);
    const Vec3<double> centre_B{lanes[0], lanes[1], lanes[2]};
    LoadFour(n_AB, lanes);
    const Vec3<double> n{lanes[0], lanes[1], lanes[2]};
    const Vec3<double> t1 = Across(n);
    const Vec3<double> t2 = Cross(n, t1);
    PutFour(n, four, batch.n);
    PutFour(t1, four, batch.t1);
    PutFour(t2, four, batch.t2);

    const Four zero{};
    for (int i = 0; i < batch.count; ++i) {
      ContactLanes<Real>& contact = rows[i];
      std::array<const double*, 4> points;
      Four J[4];
      for (std::size_t k = 0; k < 4; ++k) {
        const auto at = static_cast<std::size_t>(i);
        const bool is_used = i < counts[k];
        notes[i].used[4 * four + k] = is_used ? 1 : 0;
        points[k] =
            is_used ? pair[k]->manifold.contacts[at].p_WC.data() : kNothing.data();
        J[k] = is_used && rules.warm_starting ? Load3(pair[k]->J_W[at].data(), 0) : zero;
      }
      LoadFour(points, lanes);
      const Vec3<double> p{lanes[0], lanes[1], lanes[2]};
      PutFour(Minus(p, centre_A), four, contact.r_A);
      PutFour(Minus(p, centre_B), four, contact.r_B);
      PutFour(lanes[3], four, notes[i].separation);
      Transpose4(J[0], J[1], J[2], J[3]);
      const Vec3<double> J_W{J[0], J[1], J[2]};
      PutFour(Max(zero, Dot(J_W, n)), four, contact.impulse);
      PutFour(Dot(J_W, t1), four, contact.friction_impulse1);
      PutFour(Dot(J_W, t2), four, contact.friction_impulse2);
    }
  }
  if (rules.warm_starting && batch.count > 3) SpreadLoad(batch, rows, notes);
}

/** Tells memory what Prepare() will want of a batch. */
template <class Real>
void PrefetchBatch(const ConstraintBatch<Real>& batch, std::span<const ContactPair> pairs,
                   const SolverBodies& world) {
  for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
    if (batch.pair[lane] < 0) continue;
    PrefetchContacts(pairs[static_cast<std::size_t>(batch.pair[lane])], batch.count);
    for (const int body : {batch.A[lane], batch.B[lane]}) {
      const auto i = static_cast<std::size_t>(body);
      Prefetch(&world.bodies[i].state.p_WB, 1);
      Prefetch(&world.bodies[i].restitution, 1);
      Prefetch(&world.inertias[i], sizeof(InverseInertia));
      Prefetch(&world.before[i], 1);
      Prefetch(&world.velocities[i], 1);
    }
  }
}

template <class Real>
double Prepare(const ConstraintView<Real>& rows, const ContactRules& rules,
               std::span<const ContactPair> pairs, const SolverBodies& world) {
  using V = Vec<Real>;
  const V zero{};
  const V one = All<Real>(1);
  V greatest{};
  for (std::size_t k = 0; k < rows.batches.size(); ++k) {
    ConstraintBatch<Real>& batch = rows.batches[k];
    if (k + 1 < rows.batches.size()) PrefetchBatch(rows.batches[k + 1], pairs, world);
    const auto first = static_cast<std::size_t>(batch.first);
    ContactLanes<Real>* prepared = &rows.contacts[first];
    ContactNotes<Real>* notes = &rows.notes[first];
    Fill(batch, prepared, notes, rules, pairs, world);
    const Pairs<Real> before = PairsOf<Real>(world.before.data(), batch.A, batch.B);
    const Pairs<Real> free = PairsOf<Real>(world.velocities.data(), batch.A, batch.B);
    if (rules.warm_starting && batch.count > 1) {
      SpreadFriction(batch, prepared, notes, before, free);
    }
    const Inertias<Real> m = InertiasOf<Real>(batch);
    const Vec3<Real> n = At(batch.n);
    const Vec3<Real> t1 = At(batch.t1);
    const Vec3<Real> t2 = At(batch.t2);
    const V restitution = At(batch.restitution);
    for (int row = 0; row < batch.count; ++row) {
      ContactLanes<Real>& contact = prepared[row];
      ContactNotes<Real>& note = notes[row];
      const Vec3<Real> r_A = At(contact.r_A);
      const Vec3<Real> r_B = At(contact.r_B);
      const VecBits<Real> used = At(note.used) > zero;
      const Vec3<Real> u_before = before.At(r_A, r_B);
      const Vec3<Real> u_free = free.At(r_A, r_B);
      greatest =
          Max(greatest,
              Select(used, Max(Dot(u_before, u_before), Dot(u_free, u_free)), zero));
      const V approach = Dot(u_before, n);
      const V load = Dot(u_free, n) - approach;
      const V usual = At(batch.usual) + Abs(load);
      const V sent_back = load - restitution * approach;
      const VecBits<Real> apart = At(note.separation) > zero;
      const V fast = All<Real>(rules.resting_speed) * usual;
      const VecBits<Real> would_bounce = (approach < zero - fast) & (sent_back > zero);
      // What parts, and meets a impact of this step, comes back by the same law: held at
      // rest it would leave the other body of the impact with the energy of both.
      const VecBits<Real> leaves = restitution * approach > fast;
      const VecBits<Real> bounces = leaves | (would_bounce & ~apart);
      const VecBits<Real> steady = Abs(approach) <= All<Real>(kSteady) * usual;

      // Not there yet: what will bounce goes on, what will rest arrives with the step.
      const V arrive =
          Select(would_bounce, All<Real>(-std::numeric_limits<Real>::infinity()),
                 zero - At(note.separation) / All<Real>(rules.h));
      const V excess = zero - At(note.separation) - At(batch.slop);
      const VecBits<Real> deep = (excess > zero) & ~would_bounce;
      const V push =
          Select(deep, All<Real>(rules.baumgarte + rules.soft_rate) * excess, zero);
      const V least = Select(leaves, sent_back, Min(zero, zero - restitution * approach));
      const V target = Select(apart, Min(arrive, least),
                              Select(would_bounce, sent_back, push + least));

      const Vec3<Real> a_n = Cross(r_A, n);
      const Vec3<Real> b_n = Cross(r_B, n);
      const Vec3<Real> a_1 = Cross(r_A, t1);
      const Vec3<Real> b_1 = Cross(r_B, t1);
      const Vec3<Real> a_2 = Cross(r_A, t2);
      const Vec3<Real> b_2 = Cross(r_B, t2);
      const Vec3<Real> Ia_1 = Times(m.tensor_A, a_1);
      const Vec3<Real> Ib_1 = Times(m.tensor_B, b_1);
      const V mass = m.mass_A + m.mass_B;
      const Vec3<Real> Ia_n = Times(m.tensor_A, a_n);
      const Vec3<Real> Ib_n = Times(m.tensor_B, b_n);
      const V k_n = mass + Dot(a_n, Ia_n) + Dot(b_n, Ib_n);
      const V k_n1 = Dot(a_1, Ia_n) + Dot(b_1, Ib_n);
      const V k_n2 = Dot(a_2, Ia_n) + Dot(b_2, Ib_n);
      const V k11 = mass + Dot(a_1, Ia_1) + Dot(b_1, Ib_1);
      const V k12 = Dot(a_2, Ia_1) + Dot(b_2, Ib_1);
      const V k22 =
          mass + Dot(a_2, Times(m.tensor_A, a_2)) + Dot(b_2, Times(m.tensor_B, b_2));
      const V determinant = k11 * k22 - k12 * k12;
      const V difference = k11 - k22;
      const V k_slip =
          All<Real>(0.5) *
          (k11 + k22 + Sqrt(difference * difference + All<Real>(4) * k12 * k12));
      const V soft = Select(deep, All<Real>(rules.soft_mass_scale), one);
      const V scale = Select(deep, All<Real>(rules.soft_impulse_scale), zero);
      if constexpr (std::is_same_v<Real, float>) {
        Put(Select(used, target - Dot(u_free, n), zero), contact.target);
        Put(Select(used, Dot(u_free, t1), zero), contact.slip1);
        Put(Select(used, Dot(u_free, t2), zero), contact.slip2);
      } else {
        Put(Select(used, target, zero), contact.target);
      }
      Put(Select(used, k_n, zero), note.response);
      Put(Select(used, soft / k_n, zero), contact.effective_mass);
      Put(Select(used, scale, zero), contact.impulse_scale);
      Put(k_n1, contact.response_n1);
      Put(k_n2, contact.response_n2);
      Put(Select(used, k22 / determinant, zero), contact.stick11);
      Put(Select(used, zero - k12 / determinant, zero), contact.stick12);
      Put(Select(used, k11 / determinant, zero), contact.stick22);
      Put(Select(used, k_slip, zero), note.slip_response);
      Put(Select(used, one / k_slip, zero), contact.slip_step);
      Put(Select(bounces & used, one, zero), note.bounces);
      Put(Select(steady, one, zero), note.steady);
    }
  }
  return Greatest(Sqrt(greatest));
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
template <class Real>
double PrepareContacts(const ConstraintView<Real>& rows, const ContactRules& rules,
                       std::span<const ContactPair> pairs, const SolverBodies& world) {
  return COOKBOOK_DISPATCH(Prepare<Real>)(rows, rules, pairs, world);
}
COOKBOOK_INSTANTIATE(PrepareContacts);
}  // namespace cookbook
#endif
