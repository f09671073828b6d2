#include <algorithm>
#include <cstring>
#include <limits>
#include <span>

#include "engine/dynamics/contact_batch.h"
#include "engine/dynamics/fetch.h"

// Four lanes are one register from AVX2 on; wider ones would add nothing.
#define HWY_DISABLED_TARGETS                                                          \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dynamics/contact_kernel.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "engine/dynamics/four_bodies.h"
#include "engine/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
namespace {

/** A contact that approaches slower than this share of what gravity adds in a step is one
 that was there all along. */
constexpr double kSteady = 1.0 / 16;

/** Returns what the first four numbers are of each of four things. */
HWY_INLINE void LoadFour(const std::array<const double*, 4>& from, Four to[4]) {
  for (std::size_t lane = 0; lane < 4; ++lane) to[lane] = Load(from[lane]);
  Transpose4(to[0], to[1], to[2], to[3]);
}

HWY_INLINE void FillInertia(const std::array<const InverseInertia*, 4>& from, Lanes& mass,
                            TensorLanes& tensor) {
  static_assert(offsetof(InverseInertia, mass) == 9 * sizeof(double));
  std::array<const double*, 4> numbers;
  const auto load = [&](std::ptrdiff_t first, Four to[4]) HWY_ATTR {
    for (std::size_t k = 0; k < 4; ++k) numbers[k] = from[k]->tensor_W.data() + first;
    LoadFour(numbers, to);
  };
  Four lanes[4];
  load(0, lanes);
  Put(lanes[0], tensor[0]);
  Put(lanes[1], tensor[1]);
  Put(lanes[2], tensor[2]);
  load(4, lanes);
  Put(lanes[0], tensor[3]);
  Put(lanes[1], tensor[4]);
  load(8, lanes);
  Put(lanes[0], tensor[5]);
  Put(lanes[1], mass);
}

/** Returns a unit vector across the unit vector n, as Eigen's unitOrthogonal(). */
HWY_INLINE Four3 Across(const Four3& n) {
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
 Σ λ². Left alone where a contact carries nothing, or would pull. */
HWY_INLINE void SpreadLoad(const ContactBatch& batch, ContactLanes* rows) {
  const Four zero{};
  const Four most = Splat(std::numeric_limits<double>::max());
  Four number{};
  Four load{};
  Four lowest = most;
  Four3 centre{};
  for (int k = 0; k < batch.count; ++k) {
    const Four used = At(rows[k].used);
    const Four impulse = At(rows[k].impulse);
    number = number + used;
    load = load + impulse;
    lowest = Select(used > zero, Min(lowest, impulse), lowest);
    centre = Plus(centre, Times(used, At(rows[k].r_A)));
  }
  FourBits spreads = (number > Splat(3.5)) & (lowest > zero);
  if (Bits(spreads) == 0) return;
  const Four share = Splat(1) / Max(number, Splat(1));
  const Four mean = load * share;
  centre = Times(share, centre);
  const Four3 t1 = At(batch.t1);
  const Four3 t2 = At(batch.t2);
  Four x[8];
  Four y[8];
  Four xx{};
  Four xy{};
  Four yy{};
  Four moment_x{};
  Four moment_y{};
  for (int k = 0; k < batch.count; ++k) {
    const Four3 arm = Times(At(rows[k].used), Minus(At(rows[k].r_A), centre));
    x[k] = Dot(arm, t1);
    y[k] = Dot(arm, t2);
    xx = xx + x[k] * x[k];
    xy = xy + x[k] * y[k];
    yy = yy + y[k] * y[k];
    const Four more = At(rows[k].impulse) - mean;
    moment_x = moment_x + more * x[k];
    moment_y = moment_y + more * y[k];
  }
  // Contacts on a line have no gradient across it.
  const Four determinant = xx * yy - xy * xy;
  const Four trace = xx + yy;
  spreads &= determinant > Splat(1e-12) * trace * trace;
  const Four per = Splat(1) / Select(spreads, determinant, Splat(1));
  const Four gradient_x = per * (yy * moment_x - xy * moment_y);
  const Four gradient_y = per * (xx * moment_y - xy * moment_x);
  Four even[8];
  Four lowest_even = most;
  for (int k = 0; k < batch.count; ++k) {
    even[k] = mean + gradient_x * x[k] + gradient_y * y[k];
    lowest_even = Select(At(rows[k].used) > zero, Min(lowest_even, even[k]), lowest_even);
  }
  spreads &= lowest_even > zero;
  for (int k = 0; k < batch.count; ++k) {
    const FourBits changes = spreads & (At(rows[k].used) > zero);
    Put(Select(changes, even[k], At(rows[k].impulse)), rows[k].impulse);
  }
}

/** Spreads the impulses of friction of a face that holds as the load is spread: of all
 that have the same sum and the same moment about the normal those of least Σ f²/λ, with
 which every contact is as far from its bound as the face is, if it does not spin. Else
 contacts pull against each other across the face, by what the first sweeps left there,
 and slip too early.

 f' = λ (F/Σλ + s × (x − x̄)), x̄ the centre of the load, s = M / Σ λ (x − x̄)². Left alone
 where a contact slips, since its friction then follows from that, or where f' is beyond
 the cone. */
HWY_INLINE void SpreadFriction(const ContactBatch& batch, ContactLanes* rows,
                               const Moving& A_before, const Moving& B_before,
                               const Moving& A_free, const Moving& B_free) {
  const Four zero{};
  const Four one = Splat(1);
  const Four3 n = At(batch.n);
  const Four3 t1 = At(batch.t1);
  const Four3 t2 = At(batch.t2);
  Four number{};
  Four load{};
  Four sum1{};
  Four sum2{};
  FourBits slips = zero > zero;
  Four3 centre{};
  for (int k = 0; k < batch.count; ++k) {
    const Four impulse = At(rows[k].impulse);
    const Four3 r_A = At(rows[k].r_A);
    number = number + Select(impulse > zero, one, zero);
    load = load + impulse;
    sum1 = sum1 + At(rows[k].friction_impulse1);
    sum2 = sum2 + At(rows[k].friction_impulse2);
    centre = Plus(centre, Times(impulse, r_A));
    const Four3 r_B = At(rows[k].r_B);
    const Four3 u = RelativeVelocity(A_before, B_before, r_A, r_B);
    const Four slip1 = Dot(u, t1);
    const Four slip2 = Dot(u, t2);
    const Four pull = Dot(Minus(RelativeVelocity(A_free, B_free, r_A, r_B), u), n);
    const Four steady = Splat(kSteady) * (At(batch.usual) + Abs(pull));
    slips |= (impulse > zero) & (slip1 * slip1 + slip2 * slip2 > steady * steady);
  }
  FourBits spreads = (number > Splat(1.5)) & ~slips;
  if (Bits(spreads) == 0) return;
  const Four share = one / Select(spreads, load, one);
  centre = Times(share, centre);
  Four x[8];
  Four y[8];
  Four moment{};
  Four polar{};
  for (int k = 0; k < batch.count; ++k) {
    const Four3 arm = Minus(At(rows[k].r_A), centre);
    x[k] = Dot(arm, t1);
    y[k] = Dot(arm, t2);
    moment = moment + x[k] * At(rows[k].friction_impulse2) -
             y[k] * At(rows[k].friction_impulse1);
    polar = polar + At(rows[k].impulse) * (x[k] * x[k] + y[k] * y[k]);
  }
  const Four spin = Select(polar > zero, moment, zero) / Select(polar > zero, polar, one);
  const Four mean1 = share * sum1;
  const Four mean2 = share * sum2;
  // The sum of what is at its bound may round to beyond it.
  const Four bound = At(batch.friction) * At(batch.friction) * Splat(1 + 1e-14);
  for (int k = 0; k < batch.count; ++k) {
    const Four along1 = mean1 - spin * y[k];
    const Four along2 = mean2 + spin * x[k];
    const FourBits inside = along1 * along1 + along2 * along2 <= bound;
    spreads &= inside | ~(At(rows[k].impulse) > zero);
  }
  for (int k = 0; k < batch.count; ++k) {
    const FourBits changes = spreads & (At(rows[k].used) > zero);
    const Four impulse = At(rows[k].impulse);
    Put(Select(changes, impulse * (mean1 - spin * y[k]), At(rows[k].friction_impulse1)),
        rows[k].friction_impulse1);
    Put(Select(changes, impulse * (mean2 + spin * x[k]), At(rows[k].friction_impulse2)),
        rows[k].friction_impulse2);
  }
}

/** Fills what a batch and its rows have of the pairs. */
HWY_INLINE void Fill(ContactBatch& batch, ContactLanes* rows, const ContactRules& rules,
                     std::span<const ContactPair> pairs, const SolverBodies& world,
                     bool warm_starting) {
  static_assert(offsetof(ContactPoint, separation) == sizeof(Eigen::Vector3d));
  // Of a lane without a pair, and of what a pair has fewer of than another.
  alignas(32) constexpr std::array<double, 4> kNothing = {0, 0, 0, 0};
  alignas(32) constexpr std::array<double, 4> kAnyNormal = {1, 0, 0, 0};
  alignas(64) static const InverseInertia kImmovable{Eigen::Matrix3d::Zero(), 0};
  std::array<const ContactPair*, 4> pair;
  std::array<int, 4> counts;
  std::array<const double*, 4> n_AB;
  std::array<const double*, 4> x_A;
  std::array<const double*, 4> x_B;
  std::array<const InverseInertia*, 4> inertia_A;
  std::array<const InverseInertia*, 4> inertia_B;
  alignas(32) Lanes friction;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const bool is_pair = batch.pair[lane] >= 0;
    pair[lane] = is_pair ? &pairs[static_cast<std::size_t>(batch.pair[lane])] : nullptr;
    counts[lane] = is_pair ? pair[lane]->manifold.count : 0;
    n_AB[lane] = is_pair ? pair[lane]->manifold.n_AB_W.data() : kAnyNormal.data();
    x_A[lane] = x_B[lane] = kNothing.data();
    inertia_A[lane] = inertia_B[lane] = &kImmovable;
    friction[lane] = batch.restitution[lane] = 0;
    batch.usual[lane] = batch.slack[lane] = 0;
    if (!is_pair) continue;
    const auto a = static_cast<std::size_t>(batch.A[lane]);
    const auto b = static_cast<std::size_t>(batch.B[lane]);
    const RigidBody& A = world.bodies[a];
    const RigidBody& B = world.bodies[b];
    x_A[lane] = A.state.p_WB.data();
    x_B[lane] = B.state.p_WB.data();
    inertia_A[lane] = &world.inertias[a];
    inertia_B[lane] = &world.inertias[b];
    friction[lane] = A.friction * B.friction;
    batch.restitution[lane] = std::min(A.restitution, B.restitution);
    batch.usual[lane] = rules.h * PullOn(*pair[lane], A, B);
    batch.slack[lane] = SlackBetween(A, B);
  }
  FillInertia(inertia_A, batch.inverse_mass_A, batch.inverse_inertia_A);
  FillInertia(inertia_B, batch.inverse_mass_B, batch.inverse_inertia_B);
  Put(Sqrt(At(friction)), batch.friction);
  Four lanes[4];
  LoadFour(x_A, lanes);
  const Four3 centre_A{lanes[0], lanes[1], lanes[2]};
  LoadFour(x_B, lanes);
  const Four3 centre_B{lanes[0], lanes[1], lanes[2]};
  LoadFour(n_AB, lanes);
  const Four3 n{lanes[0], lanes[1], lanes[2]};
  const Four3 t1 = Across(n);
  const Four3 t2 = Cross(n, t1);
  Put(n, batch.n);
  Put(t1, batch.t1);
  Put(t2, batch.t2);

  const Four zero{};
  for (int k = 0; k < batch.count; ++k) {
    ContactLanes& contact = rows[k];
    std::array<const double*, 4> points;
    Four J[4];
    alignas(32) Lanes used;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto i = static_cast<std::size_t>(k);
      const bool is_used = k < counts[lane];
      used[lane] = is_used ? 1 : 0;
      points[lane] =
          is_used ? pair[lane]->manifold.contacts[i].p_WC.data() : kNothing.data();
      J[lane] = is_used && warm_starting ? Load3(pair[lane]->J_W[i].data(), 0) : zero;
    }
    LoadFour(points, lanes);
    const Four3 p{lanes[0], lanes[1], lanes[2]};
    Put(Minus(p, centre_A), contact.r_A);
    Put(Minus(p, centre_B), contact.r_B);
    Put(lanes[3], contact.separation);
    contact.used = used;
    Transpose4(J[0], J[1], J[2], J[3]);
    const Four3 J_W{J[0], J[1], J[2]};
    Put(Max(zero, Dot(J_W, n)), contact.impulse);
    Put(Dot(J_W, t1), contact.friction_impulse1);
    Put(Dot(J_W, t2), contact.friction_impulse2);
  }
  if (warm_starting && batch.count > 3) SpreadLoad(batch, rows);
}

/** Tells memory what Prepare() will want of a batch. */
void FetchBatch(const ContactBatch& batch, std::span<const ContactPair> pairs,
                const SolverBodies& world) {
  const auto impulses = static_cast<std::size_t>(batch.count) * sizeof(Eigen::Vector3d);
  const std::size_t manifold =
      offsetof(ContactPair, manifold) + offsetof(Manifold, contacts) +
      static_cast<std::size_t>(batch.count) * sizeof(ContactPoint);
  for (std::size_t lane = 0; lane < 4; ++lane) {
    if (batch.pair[lane] < 0) continue;
    const ContactPair& pair = pairs[static_cast<std::size_t>(batch.pair[lane])];
    Fetch(&pair, manifold);
    Fetch(&pair.J_W, impulses);
    for (const int body : {batch.A[lane], batch.B[lane]}) {
      const auto i = static_cast<std::size_t>(body);
      Fetch(&world.bodies[i].state.p_WB, 1);
      Fetch(&world.bodies[i].restitution, 1);
      Fetch(&world.inertias[i], sizeof(InverseInertia));
      Fetch(&world.before[i], 1);
      Fetch(&world.velocities[i], 1);
    }
  }
}

double Prepare(const ContactRows& rows, const ContactRules& rules,
               std::span<const ContactPair> pairs, const SolverBodies& world,
               bool warm_starting) {
  const Velocity* before = world.before.data();
  const Velocity* velocities = world.velocities.data();
  const Four zero{};
  const Four one = Splat(1);
  Four greatest{};
  for (std::size_t k = 0; k < rows.batches.size(); ++k) {
    ContactBatch& batch = rows.batches[k];
    if (k + 1 < rows.batches.size()) FetchBatch(rows.batches[k + 1], pairs, world);
    ContactLanes* prepared = &rows.contacts[static_cast<std::size_t>(batch.first)];
    Fill(batch, prepared, rules, pairs, world, warm_starting);
    const Moving A_before = Gather(before, batch.A);
    const Moving B_before = Gather(before, batch.B);
    const Moving A_free = Gather(velocities, batch.A);
    const Moving B_free = Gather(velocities, batch.B);
    if (warm_starting && batch.count > 1) {
      SpreadFriction(batch, prepared, A_before, B_before, A_free, B_free);
    }
    const Inertias m = InertiasOf(batch);
    const Four3 n = At(batch.n);
    const Four3 t1 = At(batch.t1);
    const Four3 t2 = At(batch.t2);
    const Four restitution = At(batch.restitution);
    for (int row = 0; row < batch.count; ++row) {
      ContactLanes& contact = prepared[row];
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
      const Four usual = At(batch.usual) + Abs(pull);
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
      const Four excess = zero - At(contact.separation) - At(batch.slack);
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
    const ContactLanes* of_batch = &rows.contacts[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      const ContactLanes& contact = of_batch[k];
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
  Four relaxation;
  Four changed{};

  /** Returns `changed`, and +∞ in lanes without a pair. */
  HWY_INLINE Four ChangedOfPairs() const {
    return Select(m.mass_A + m.mass_B > Four{}, changed,
                  Splat(std::numeric_limits<double>::infinity()));
  }
};

HWY_INLINE Swept Begin(ContactBatch& batch, const ContactRows& rows, Four relaxation,
                       const Velocity* velocities) {
  return {batch,
          &rows.contacts[static_cast<std::size_t>(batch.first)],
          Gather(velocities, batch.A),
          Gather(velocities, batch.B),
          InertiasOf(batch),
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
template <Kind kind>
HWY_INLINE void SolveRow(ContactLanes& contact, Four kept, Swept& at) {
  const Four zero{};
  const Four3 r_A = At(contact.r_A);
  const Four3 r_B = At(contact.r_B);

  const Four3 u = RelativeVelocity(at.A, at.B, r_A, r_B);
  const Four sum = At(contact.impulse);
  const Four start = kind == Kind::kPlain ? sum : kept * sum;
  const Four softened =
      kind == Kind::kPlain ? start : start - At(contact.impulse_scale) * sum;
  const Four mass = at.relaxation * At(contact.effective_mass);
  const Four impulse = Max(zero, softened + mass * (At(contact.target) - Dot(u, at.n)));
  const Four change = impulse - start;
  Put(kind == Kind::kPlain ? impulse : sum + change, contact.impulse);

  const Four slip1 = Dot(u, at.t1) + change * At(contact.response_n1);
  const Four slip2 = Dot(u, at.t2) + change * At(contact.response_n2);
  const Four bound = at.friction * impulse;
  const Four bound_squared = bound * bound;
  const Four sum1 = At(contact.friction_impulse1);
  const Four sum2 = At(contact.friction_impulse2);
  const Four held1 = kind == Kind::kPlain ? sum1 : kept * sum1;
  const Four held2 = kind == Kind::kPlain ? sum2 : kept * sum2;
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

template <Kind kind>
Changes SweepKind(const ContactRows& rows, bool accumulated, double relaxation,
                  Velocity* velocities) {
  const Four kept = Splat(accumulated ? 1 : 0);
  const Four relaxed = Splat(relaxation);
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
    Swept one = Begin(rows.batches[k], rows, relaxed, velocities);
    if (second == count) {
      for (int i = 0; i < one.batch.count; ++i) SolveRow<kind>(one.rows[i], kept, one);
      End(one, velocities);
      greatest = Max(greatest, one.changed);
      least = Min(least, one.ChangedOfPairs());
      break;
    }
    Swept two = Begin(rows.batches[second], rows, relaxed, velocities);
    const int both = std::min(one.batch.count, two.batch.count);
    for (int i = 0; i < both; ++i) {
      SolveRow<kind>(one.rows[i], kept, one);
      SolveRow<kind>(two.rows[i], kept, two);
    }
    for (int i = both; i < one.batch.count; ++i) SolveRow<kind>(one.rows[i], kept, one);
    for (int i = both; i < two.batch.count; ++i) SolveRow<kind>(two.rows[i], kept, two);
    End(one, velocities);
    End(two, velocities);
    greatest = Max(greatest, Max(one.changed, two.changed));
    least = Min(least, Min(one.ChangedOfPairs(), two.ChangedOfPairs()));
    k = next_at_work(second + 1);
  }
  return {Greatest(greatest), -Greatest(-least)};
}

Changes Sweep(const ContactRows& rows, const ContactRules& rules, double relaxation,
              Velocity* velocities) {
  const bool is_plain = rules.accumulated && rules.soft_impulse_scale == 0;
  return (is_plain
              ? SweepKind<Kind::kPlain>
              : SweepKind<Kind::kAny>)(rows, rules.accumulated, relaxation, velocities);
}

void Read(const ContactRows& rows, std::span<ContactPair> pairs, Touch* touches) {
  const Four zero{};
  for (const ContactBatch& batch : rows.batches) {
    std::array<ContactPair*, 4> pair{};
    std::array<int, 4> counts{};
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (batch.pair[lane] < 0) continue;
      pair[lane] = &pairs[static_cast<std::size_t>(batch.pair[lane])];
      counts[lane] = pair[lane]->manifold.count;
    }
    const Four3 n = At(batch.n);
    const Four3 t1 = At(batch.t1);
    const Four3 t2 = At(batch.t2);
    FourBits bounced{};
    FourBits rested{};
    FourBits unsteady{};
    const ContactLanes* of_batch = &rows.contacts[static_cast<std::size_t>(batch.first)];
    for (int k = 0; k < batch.count; ++k) {
      const ContactLanes& contact = of_batch[k];
      const Four impulse = At(contact.impulse);
      const Four3 J =
          Plus(Plus(Times(impulse, n), Times(At(contact.friction_impulse1), t1)),
               Times(At(contact.friction_impulse2), t2));
      Four J_W[4] = {J.x, J.y, J.z, zero};
      Transpose4(J_W[0], J_W[1], J_W[2], J_W[3]);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (k >= counts[lane]) continue;
        std::memcpy(pair[lane]->J_W[static_cast<std::size_t>(k)].data(), &J_W[lane],
                    sizeof(Eigen::Vector3d));
      }
      const FourBits acts = impulse > zero;
      const FourBits bounces = At(contact.bounces) > zero;
      bounced |= acts & bounces;
      rested |= acts & ~bounces;
      unsteady |= acts & ~(At(contact.steady) > zero);
    }
    const unsigned who_bounced = Bits(bounced);
    const unsigned who_rested = Bits(rested);
    const unsigned who_is_unsteady = Bits(unsteady);
    for (std::size_t lane = 0; lane < 4; ++lane) {
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
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(Prepare);
HWY_EXPORT(ApplyAll);
HWY_EXPORT(Sweep);
HWY_EXPORT(Read);

double PrepareContacts(const ContactRows& rows, const ContactRules& rules,
                       std::span<const ContactPair> pairs, const SolverBodies& world,
                       bool warm_starting) {
  return HWY_DYNAMIC_DISPATCH(Prepare)(rows, rules, pairs, world, warm_starting);
}

void ApplyImpulses(const ContactRows& rows, std::span<Velocity> velocities) {
  HWY_DYNAMIC_DISPATCH(ApplyAll)(rows, velocities.data());
}

Changes SweepContacts(const ContactRows& rows, const ContactRules& rules,
                      double relaxation, std::span<Velocity> velocities) {
  return HWY_DYNAMIC_DISPATCH(Sweep)(rows, rules, relaxation, velocities.data());
}

void ReadContacts(const ContactRows& rows, std::span<ContactPair> pairs,
                  std::span<Touch> touches) {
  HWY_DYNAMIC_DISPATCH(Read)(rows, pairs, touches.data());
}
}  // namespace cookbook
#endif
