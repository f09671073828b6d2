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

/** Greatest sag of a contact that yields, as a fraction of SmallerInnerRadius(). The
 spring of a contact follows from the mass of the lighter body. With that alone, a body
 under one that is a thousand times heavier would sink in by centimetres. */
constexpr double kMaxSag = 0.01;

/** A contact is steady if its normal speed before the step was at most this fraction of
 the speed that the loads add in a step: it has been closed for a while. It slips if its
 slip was faster than that. */
constexpr double kSteadyFraction = 1.0 / 16;

/** Greatest deviation to which a contact yields, in multiples of the mean load of the
 contacts of its pair. Loads of bodies that rock deviate by a few, impacts by hundreds:
 a contact that passes on an impact is nearly rigid. */
constexpr double kMaxDeviation = 20;

/** Number of sub-steps for which a pair is rigid after it came to rest. New contacts have
 no impulses for warm starting: their loads vary until the solver has found them. */
constexpr int kRigidSteps = 24;

/** Relative rounding error of a sum. */
template <class Real>
constexpr double kRounding = std::is_same_v<Real, float> ? 1e-6 : 1e-14;
/** A face narrower than the square root of this fraction of its length counts as a line:
 a load spread across it would have an error of some roundings divided by this fraction.
 */
template <class Real>
constexpr double kLineFraction = std::is_same_v<Real, float> ? 1e-3 : 1e-12;

/** Returns the position of a contact relative to a body of its pair. In single precision
 this is the nearer body: relative to the centre of a wide ground, the distances between
 contacts would be lost in rounding. */
template <class Real>
HWY_INLINE Vec3<Real> PositionOf(const ContactConstraintLanes<Real>& first,
                                 const ContactConstraintLanes<Real>& contact) {
  const Vec3<Real> r_A = Load(contact.r_A);
  if constexpr (std::is_same_v<Real, double>) {
    return r_A;
  } else {
    const Vec3<Real> A = Load(first.r_A);
    const Vec3<Real> B = Load(first.r_B);
    const VecBits<Real> nearer = Dot(B, B) < Dot(A, A);
    const Vec3<Real> r_B = Load(contact.r_B);
    return {Select(nearer, r_B.x, r_A.x), Select(nearer, r_B.y, r_A.y),
            Select(nearer, r_B.z, r_A.z)};
  }
}

/** Returns a unit vector orthogonal to the unit vector n, like Eigen's unitOrthogonal().
 */
HWY_INLINE Vec3<double> UnitOrthogonal(const Vec3<double>& n) {
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

/** A linear distribution of loads over a face: mean + gradient · (x − x̄). [N s] */
template <class Real>
struct LinearLoad {
  Vec<Real> mean;
  Vec<Real> gradient_x;
  Vec<Real> gradient_y;

  HWY_INLINE Vec<Real> At(Vec<Real> x, Vec<Real> y) const {
    return mean + gradient_x * x + gradient_y * y;
  }
};

/** Redistributes the normal impulses of each face, and their mean loads, as a rigid body
 on a uniform elastic foundation would: linearly in position, with the same sum and the
 same moments. The load of a face with four or more contacts is statically indeterminate.
 Which solution the iterations find, and warm starting passes on, depends on their order,
 and the friction of a sliding face depends on the solution.

 λ' = λ̄ + g·(x − x̄), where g is the least-squares gradient of λ − λ̄: of all λ with these
 sums this one has the least Σ λ². The impulses stay as they are if there are fewer than
 four, if one of them is zero, if the contacts are on a line, or if one would have to
 pull. */
template <class Real>
HWY_INLINE void SpreadLoad(const ConstraintBatch<Real>& batch,
                           ContactConstraintLanes<Real>* contacts,
                           const ContactColdLanes<Real>* cold) {
  using V = Vec<Real>;
  const V zero{};
  const V one = Splat<Real>(1);
  const V largest = Splat<Real>(std::numeric_limits<Real>::max());
  V count{};
  V least = largest;
  Vec3<Real> centre{};
  for (int k = 0; k < batch.count; ++k) {
    const V used = Load(cold[k].used);
    count = count + used;
    least = Select(used > zero, Min(least, Load(contacts[k].impulse)), least);
    centre = Plus(centre, Times(used, PositionOf(contacts[0], contacts[k])));
  }
  VecBits<Real> can_spread = (count > Splat<Real>(3.5)) & (least > zero);
  if (Bits(can_spread) == 0) return;
  const V inverse_count = one / Max(count, one);
  centre = Times(inverse_count, centre);
  const Vec3<Real> t1 = Load(batch.t1);
  const Vec3<Real> t2 = Load(batch.t2);
  V x[8];
  V y[8];
  V xx{};
  V xy{};
  V yy{};
  for (int k = 0; k < batch.count; ++k) {
    const Vec3<Real> arm =
        Times(Load(cold[k].used), Minus(PositionOf(contacts[0], contacts[k]), centre));
    x[k] = Dot(arm, t1);
    y[k] = Dot(arm, t2);
    xx = xx + x[k] * x[k];
    xy = xy + x[k] * y[k];
    yy = yy + y[k] * y[k];
  }
  // The gradient across a line of contacts is undefined.
  const V determinant = xx * yy - xy * xy;
  const V trace = xx + yy;
  can_spread &= determinant > Splat<Real>(kLineFraction<Real>) * trace * trace;
  const V inverse_determinant = one / Select(can_spread, determinant, one);
  const auto fit = [&](Lanes<Real> ContactConstraintLanes<Real>::*load) HWY_ATTR {
    V sum{};
    for (int k = 0; k < batch.count; ++k) sum = sum + Load(contacts[k].*load);
    const V mean = sum * inverse_count;
    V moment_x{};
    V moment_y{};
    for (int k = 0; k < batch.count; ++k) {
      const V deviation = Load(contacts[k].*load) - mean;
      moment_x = moment_x + deviation * x[k];
      moment_y = moment_y + deviation * y[k];
    }
    return LinearLoad<Real>{mean, inverse_determinant * (yy * moment_x - xy * moment_y),
                            inverse_determinant * (xx * moment_y - xy * moment_x)};
  };
  const LinearLoad<Real> impulse = fit(&ContactConstraintLanes<Real>::impulse);
  const LinearLoad<Real> mean_load = fit(&ContactConstraintLanes<Real>::mean_load);
  V least_linear = largest;
  for (int k = 0; k < batch.count; ++k) {
    least_linear = Select(Load(cold[k].used) > zero,
                          Min(least_linear, impulse.At(x[k], y[k])), least_linear);
  }
  can_spread &= least_linear > zero;
  for (int k = 0; k < batch.count; ++k) {
    const VecBits<Real> changes = can_spread & (Load(cold[k].used) > zero);
    Store(Select(changes, impulse.At(x[k], y[k]), Load(contacts[k].impulse)),
          contacts[k].impulse);
    Store(Select(changes, mean_load.At(x[k], y[k]), Load(contacts[k].mean_load)),
          contacts[k].mean_load);
  }
}

/** Sets `max_deviation` of a batch, which is 1 for pairs that yield and 0 for others. */
template <class Real>
HWY_INLINE void SetMaxDeviation(const ContactParameters& parameters,
                                const ContactConstraintLanes<Real>* contacts,
                                const ContactColdLanes<Real>* cold,
                                ConstraintBatch<Real>& batch) {
  using V = Vec<Real>;
  if (parameters.soft_impulse_scale > 0) {
    batch.max_deviation.fill(std::numeric_limits<Real>::infinity());
    return;
  }
  V load{};
  V count{};
  for (int k = 0; k < batch.count; ++k) {
    load = load + Load(contacts[k].mean_load);
    count = count + Load(cold[k].used);
  }
  const V yields = Load(batch.max_deviation);
  Store(yields * Splat<Real>(kMaxDeviation) * load / Max(count, Splat<Real>(1)),
        batch.max_deviation);
}

/** Redistributes the friction impulses of each sticking face in proportion to its load,
 with the same sum and the same moment about the normal. They have the least
 Σ f²/λ of all such impulses: without a moment, every contact is as far from its friction
 bound as the whole face. Otherwise the remains of the first iterations make contacts pull
 against each other across the face, and they slip too early.

 f' = λ (F/Σλ + s × (x − x̄)), where x̄ is the centre of the load and s = M / Σ λ (x − x̄)².
 The impulses stay as they are if a contact slips, since the slip then determines its
 friction, or if some f' is outside the cone. */
template <class Real>
HWY_INLINE void SpreadFriction(const ConstraintBatch<Real>& batch,
                               ContactConstraintLanes<Real>* contacts,
                               const ContactColdLanes<Real>* cold,
                               const PairVelocities<Real>& before,
                               const PairVelocities<Real>& free) {
  using V = Vec<Real>;
  const V zero{};
  const V one = Splat<Real>(1);
  const Vec3<Real> n = Load(batch.n);
  const Vec3<Real> t1 = Load(batch.t1);
  const Vec3<Real> t2 = Load(batch.t2);
  V count{};
  V load{};
  V sum1{};
  V sum2{};
  VecBits<Real> slips = zero > zero;
  Vec3<Real> centre{};
  for (int k = 0; k < batch.count; ++k) {
    const V impulse = Load(contacts[k].impulse);
    const Vec3<Real> r_A = Load(contacts[k].r_A);
    count = count + Select(impulse > zero, one, zero);
    load = load + impulse;
    sum1 = sum1 + Load(contacts[k].friction_impulse1);
    sum2 = sum2 + Load(contacts[k].friction_impulse2);
    centre = Plus(centre, Times(impulse, PositionOf(contacts[0], contacts[k])));
    const Vec3<Real> r_B = Load(contacts[k].r_B);
    const Vec3<Real> u = before.RelativeAt(r_A, r_B);
    const V slip1 = Dot(u, t1);
    const V slip2 = Dot(u, t2);
    const V change = Dot(Minus(free.RelativeAt(r_A, r_B), u), n);
    const V steady_speed =
        Splat<Real>(kSteadyFraction) * (Load(batch.load_speed) + Abs(change));
    slips |=
        (impulse > zero) & (slip1 * slip1 + slip2 * slip2 > steady_speed * steady_speed);
  }
  VecBits<Real> can_spread = (count > Splat<Real>(1.5)) & ~slips;
  if (Bits(can_spread) == 0) return;
  const V inverse_load = one / Select(can_spread, load, one);
  centre = Times(inverse_load, centre);
  V x[8];
  V y[8];
  V moment{};
  V polar{};
  for (int k = 0; k < batch.count; ++k) {
    const Vec3<Real> arm = Minus(PositionOf(contacts[0], contacts[k]), centre);
    x[k] = Dot(arm, t1);
    y[k] = Dot(arm, t2);
    moment = moment + x[k] * Load(contacts[k].friction_impulse2) -
             y[k] * Load(contacts[k].friction_impulse1);
    polar = polar + Load(contacts[k].impulse) * (x[k] * x[k] + y[k] * y[k]);
  }
  const V spin = Select(polar > zero, moment, zero) / Select(polar > zero, polar, one);
  const V mean1 = inverse_load * sum1;
  const V mean2 = inverse_load * sum2;
  // A sum of impulses on the cone may be outside by rounding.
  const V bound =
      Load(batch.friction) * Load(batch.friction) * Splat<Real>(1 + kRounding<Real>);
  for (int k = 0; k < batch.count; ++k) {
    const V scaled1 = mean1 - spin * y[k];
    const V scaled2 = mean2 + spin * x[k];
    const VecBits<Real> inside = scaled1 * scaled1 + scaled2 * scaled2 <= bound;
    can_spread &= inside | ~(Load(contacts[k].impulse) > zero);
  }
  for (int k = 0; k < batch.count; ++k) {
    const VecBits<Real> changes = can_spread & (Load(cold[k].used) > zero);
    const V impulse = Load(contacts[k].impulse);
    Store(Select(changes, impulse * (mean1 - spin * y[k]),
                 Load(contacts[k].friction_impulse1)),
          contacts[k].friction_impulse1);
    Store(Select(changes, impulse * (mean2 + spin * x[k]),
                 Load(contacts[k].friction_impulse2)),
          contacts[k].friction_impulse2);
  }
}

/** Loads the data of the pairs and bodies of a batch and of its contacts. */
template <class Real>
HWY_INLINE void LoadPairs(ConstraintBatch<Real>& batch,
                          ContactConstraintLanes<Real>* contacts,
                          ContactColdLanes<Real>* cold,
                          const ContactParameters& parameters,
                          std::span<const ContactPair> pairs,
                          const SolverBodies& bodies) {
  static_assert(offsetof(ContactPoint, separation) == sizeof(Eigen::Vector3d));
  // Defaults for lanes without a pair, and for contacts that a pair does not have.
  alignas(32) constexpr std::array<double, 4> kZeros = {0, 0, 0, 0};
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
    // Impulses of a step of another length, for example half of a step.
    std::array<double, 4> impulse_scale = {1, 1, 1, 1};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t lane = 4 * four + k;
      const bool is_pair = batch.pair[lane] >= 0;
      pair[k] = is_pair ? &pairs[static_cast<std::size_t>(batch.pair[lane])] : nullptr;
      counts[k] = is_pair ? pair[k]->manifold.count : 0;
      n_AB[k] = is_pair ? pair[k]->manifold.n_AB_W.data() : kAnyNormal.data();
      x_A[k] = x_B[k] = kZeros.data();
      inertia_A[k] = inertia_B[k] = &kImmovable;
      friction[k] = 0;
      batch.restitution[lane] = batch.load_speed[lane] = batch.slop[lane] = 0;
      batch.max_sag[lane] = 0;
      batch.max_deviation[lane] = 0;
      if (!is_pair) continue;
      const auto a = static_cast<std::size_t>(batch.A[lane]);
      const auto b = static_cast<std::size_t>(batch.B[lane]);
      const RigidBody& A = bodies.rigid_bodies[a];
      const RigidBody& B = bodies.rigid_bodies[b];
      x_A[k] = A.state.p_WB.data();
      x_B[k] = B.state.p_WB.data();
      inertia_A[k] = &bodies.inertias[a];
      inertia_B[k] = &bodies.inertias[b];
      friction[k] = A.friction * B.friction;
      batch.restitution[lane] = static_cast<Real>(parameters.restitution_factor *
                                                  std::min(A.restitution, B.restitution));
      batch.load_speed[lane] =
          static_cast<Real>(parameters.h * LoadAccelerationOn(*pair[k], A, B));
      batch.slop[lane] = static_cast<Real>(SlopBetween(A, B));
      batch.max_sag[lane] = static_cast<Real>(kMaxSag * SmallerInnerRadius(A, B));
      if (pair[k]->loaded_steps >= kRigidSteps) batch.max_deviation[lane] = 1;
      if (pair[k]->impulse_time > 0)
        impulse_scale[k] = parameters.h / pair[k]->impulse_time;
    }
    const auto load_inertias = [&](const std::array<const InverseInertia*, 4>& from,
                                   Lanes<Real>& mass,
                                   TensorLanes<Real>& tensor) HWY_ATTR {
      Tensor<double> t;
      StoreFour(GatherInverseInertias(from, t), four, mass);
      StoreFour(t.xx, four, tensor[0]);
      StoreFour(t.xy, four, tensor[1]);
      StoreFour(t.xz, four, tensor[2]);
      StoreFour(t.yy, four, tensor[3]);
      StoreFour(t.yz, four, tensor[4]);
      StoreFour(t.zz, four, tensor[5]);
    };
    load_inertias(inertia_A, batch.inverse_mass_A, batch.inverse_inertia_A);
    load_inertias(inertia_B, batch.inverse_mass_B, batch.inverse_inertia_B);
    StoreFour(Sqrt(Load(friction)), four, batch.friction);
    Four lanes[4];
    LoadTransposed(x_A, lanes);
    const Vec3<double> centre_A{lanes[0], lanes[1], lanes[2]};
    LoadTransposed(x_B, lanes);
    const Vec3<double> centre_B{lanes[0], lanes[1], lanes[2]};
    LoadTransposed(n_AB, lanes);
    const Vec3<double> n{lanes[0], lanes[1], lanes[2]};
    const Vec3<double> t1 = UnitOrthogonal(n);
    const Vec3<double> t2 = Cross(n, t1);
    StoreFour(n, four, batch.n);
    StoreFour(t1, four, batch.t1);
    StoreFour(t2, four, batch.t2);

    const Four zero{};
    for (int i = 0; i < batch.count; ++i) {
      ContactConstraintLanes<Real>& contact = contacts[i];
      std::array<const double*, 4> points;
      Four J[4];
      for (std::size_t k = 0; k < 4; ++k) {
        const auto at = static_cast<std::size_t>(i);
        const bool is_used = i < counts[k];
        cold[i].used[4 * four + k] = is_used ? 1 : 0;
        points[k] = is_used ? pair[k]->manifold.contacts[at].p_WC.data() : kZeros.data();
        J[k] = is_used && parameters.warm_starting
                   ? Splat(impulse_scale[k]) * Load3(pair[k]->J_W[at].data(), 0)
                   : zero;
      }
      for (std::size_t k = 0; k < 4; ++k) {
        const bool is_used = i < counts[k];
        contact.mean_load[4 * four + k] =
            is_used ? static_cast<Real>(impulse_scale[k] *
                                        pair[k]->mean_load[static_cast<std::size_t>(i)])
                    : Real{0};
      }
      LoadTransposed(points, lanes);
      const Vec3<double> p{lanes[0], lanes[1], lanes[2]};
      StoreFour(Minus(p, centre_A), four, contact.r_A);
      StoreFour(Minus(p, centre_B), four, contact.r_B);
      StoreFour(lanes[3], four, cold[i].separation);
      Transpose4(J[0], J[1], J[2], J[3]);
      const Vec3<double> J_W{J[0], J[1], J[2]};
      StoreFour(Max(zero, Dot(J_W, n)), four, contact.impulse);
      StoreFour(Dot(J_W, t1), four, contact.friction_impulse1);
      StoreFour(Dot(J_W, t2), four, contact.friction_impulse2);
    }
  }
  if (parameters.warm_starting && batch.count > 3) SpreadLoad(batch, contacts, cold);
}

/** Prefetches what Prepare() reads for a batch. */
template <class Real>
void PrefetchBatch(const ConstraintBatch<Real>& batch, std::span<const ContactPair> pairs,
                   const SolverBodies& bodies) {
  for (std::size_t lane = 0; lane < kLanes<Real>; ++lane) {
    if (batch.pair[lane] < 0) continue;
    PrefetchContacts(pairs[static_cast<std::size_t>(batch.pair[lane])], batch.count);
    for (const int body : {batch.A[lane], batch.B[lane]}) {
      const auto i = static_cast<std::size_t>(body);
      Prefetch(&bodies.rigid_bodies[i].state.p_WB, 1);
      Prefetch(&bodies.rigid_bodies[i].restitution, 1);
      Prefetch(&bodies.inertias[i], sizeof(InverseInertia));
      Prefetch(&bodies.velocities_before[i], 1);
      Prefetch(&bodies.velocities[i], 1);
    }
  }
}

template <class Real>
double Prepare(const ConstraintView<Real>& constraints,
               const ContactParameters& parameters, std::span<const ContactPair> pairs,
               const SolverBodies& bodies) {
  using V = Vec<Real>;
  const V zero{};
  const V one = Splat<Real>(1);
  V max_squared{};
  for (std::size_t index = 0; index < constraints.batches.size(); ++index) {
    ConstraintBatch<Real>& batch = constraints.batches[index];
    if (index + 1 < constraints.batches.size()) {
      PrefetchBatch(constraints.batches[index + 1], pairs, bodies);
    }
    const auto first = static_cast<std::size_t>(batch.first);
    ContactConstraintLanes<Real>* contacts = &constraints.contacts[first];
    ContactColdLanes<Real>* cold = &constraints.cold[first];
    LoadPairs(batch, contacts, cold, parameters, pairs, bodies);
    const PairVelocities<Real> before =
        GatherPairVelocities<Real>(bodies.velocities_before.data(), batch.A, batch.B);
    const PairVelocities<Real> free =
        GatherPairVelocities<Real>(bodies.velocities.data(), batch.A, batch.B);
    if (parameters.warm_starting && batch.count > 1) {
      SpreadFriction(batch, contacts, cold, before, free);
    }
    const InverseInertias<Real> m = LoadInverseInertias<Real>(batch);
    const Vec3<Real> n = Load(batch.n);
    const Vec3<Real> t1 = Load(batch.t1);
    const Vec3<Real> t2 = Load(batch.t2);
    SetMaxDeviation(parameters, contacts, cold, batch);
    const V max_deviation = Load(batch.max_deviation);
    const V restitution = Load(batch.restitution);
    // After the impacts a contact may come back as fast as it left, so that its impulse
    // does no work at the mean of the two velocities.
    const VecBits<Real> bounces =
        Splat<Real>(parameters.impacts_resolved ? -1 : 1) > zero;
    const V rebound = Select(bounces, restitution, one);
    for (int k = 0; k < batch.count; ++k) {
      ContactConstraintLanes<Real>& contact = contacts[k];
      ContactColdLanes<Real>& data = cold[k];
      const Vec3<Real> r_A = Load(contact.r_A);
      const Vec3<Real> r_B = Load(contact.r_B);

      // Relative velocity, before the step and at its end without impulses.
      const VecBits<Real> used = Load(data.used) > zero;
      const Vec3<Real> u_before = before.RelativeAt(r_A, r_B);
      const Vec3<Real> u_free = free.RelativeAt(r_A, r_B);
      max_squared =
          Max(max_squared,
              Select(used, Max(Dot(u_before, u_before), Dot(u_free, u_free)), zero));

      // Restitution.
      const V un_before = Dot(u_before, n);
      const V change = Dot(u_free, n) - un_before;
      const V load_speed = Load(batch.load_speed) + Abs(change);
      const V bounce = change - restitution * un_before;
      const VecBits<Real> is_apart = Load(data.separation) > zero;
      const V resting_speed =
          Splat<Real>(parameters.restitution_threshold_factor) * load_speed;
      const VecBits<Real> approaches = un_before < zero - resting_speed;
      const VecBits<Real> would_bounce = approaches & (bounce > zero) & bounces;
      // A contact that separates and is hit by an impact of this step comes back by the
      // same law. Held at rest, it would leave the energy of both bodies to the other
      // one.
      const VecBits<Real> separates = (restitution * un_before > resting_speed) & bounces;
      const VecBits<Real> is_bouncing = separates | (would_bounce & ~is_apart);
      const VecBits<Real> is_steady =
          Abs(un_before) <= Splat<Real>(kSteadyFraction) * load_speed;

      // Speculative contact: one that will rest closes by the end of the step; one that
      // will bounce, or have an impact in the next step, is off until it is closed.
      const V speculative =
          Select(would_bounce | (approaches & ~bounces),
                 Splat<Real>(-std::numeric_limits<Real>::infinity()),
                 zero - Load(data.separation) / Splat<Real>(parameters.h));

      // Response of the relative velocity to unit impulses along n, t1 and t2, and the
      // effective masses, its inverses.
      const Vec3<Real> a_n = Cross(r_A, n);
      const Vec3<Real> b_n = Cross(r_B, n);
      const Vec3<Real> a_1 = Cross(r_A, t1);
      const Vec3<Real> b_1 = Cross(r_B, t1);
      const Vec3<Real> a_2 = Cross(r_A, t2);
      const Vec3<Real> b_2 = Cross(r_B, t2);
      const Vec3<Real> Ia_1 = Times(m.inverse_inertia_A, a_1);
      const Vec3<Real> Ib_1 = Times(m.inverse_inertia_B, b_1);
      const V mass = m.inverse_mass_A + m.inverse_mass_B;
      const Vec3<Real> Ia_n = Times(m.inverse_inertia_A, a_n);
      const Vec3<Real> Ib_n = Times(m.inverse_inertia_B, b_n);
      const V k_n = mass + Dot(a_n, Ia_n) + Dot(b_n, Ib_n);
      const V k_n1 = Dot(a_1, Ia_n) + Dot(b_1, Ib_n);
      const V k_n2 = Dot(a_2, Ia_n) + Dot(b_2, Ib_n);
      const V k11 = mass + Dot(a_1, Ia_1) + Dot(b_1, Ib_1);
      const V k12 = Dot(a_2, Ia_1) + Dot(b_2, Ib_1);
      const V k22 = mass + Dot(a_2, Times(m.inverse_inertia_A, a_2)) +
                    Dot(b_2, Times(m.inverse_inertia_B, b_2));
      const V determinant = k11 * k22 - k12 * k12;
      const V difference = k11 - k22;
      // Greatest eigenvalue of the tangential response, for the step against the slip.
      const V max_slip_response =
          Splat<Real>(0.5) *
          (k11 + k22 + Sqrt(difference * difference + Splat<Real>(4) * k12 * k12));

      // A contact that rests in a pair with a mean load yields.
      const VecBits<Real> yields = (max_deviation > zero) & ~would_bounce & ~is_apart;
      // Its spring is stiffer if it would sag by more than the greatest sag.
      const V sag_per_load = Splat<Real>(parameters.sag_time) * k_n;
      const V mean_load = Load(contact.mean_load);
      const V stiffness = Max(one, sag_per_load * Max(mean_load, Load(contact.impulse)) /
                                       Load(batch.max_sag));
      const V yield = Select(yields, Splat<Real>(parameters.yield) / stiffness, zero);
      // It sags under the mean load. Correcting that would give back, in each swing of a
      // column, the energy that the damper has taken.
      const V sag = Select(yields, sag_per_load * mean_load / stiffness, zero);
      const V slop = Load(batch.slop) + sag;

      // Stabilisation of contacts deeper than the slop (Baumgarte or soft).
      const V depth = zero - Load(data.separation) - slop;
      const VecBits<Real> is_deep = (depth > zero) & ~would_bounce;
      const V stabilisation =
          Select(is_deep,
                 Splat<Real>(parameters.baumgarte + parameters.soft_rate) * depth, zero);

      // Target of the relative normal velocity.
      const V resting = Select(separates, bounce, Min(zero, zero - rebound * un_before));
      const V target = Select(is_apart, Min(speculative, resting),
                              Select(would_bounce, bounce, stabilisation + resting));
      const V soft =
          Select(is_deep, Splat<Real>(parameters.soft_mass_scale), one) * (one - yield);
      const V scale =
          Select(is_deep, Splat<Real>(parameters.soft_impulse_scale), zero) + yield;

      if constexpr (std::is_same_v<Real, float>) {
        Store(Select(used, target - Dot(u_free, n), zero), contact.target);
        Store(Select(used, Dot(u_free, t1), zero), contact.free_slip1);
        Store(Select(used, Dot(u_free, t2), zero), contact.free_slip2);
      } else {
        Store(Select(used, target, zero), contact.target);
      }
      Store(slop, data.slop);
      Store(Select(used, k_n, zero), data.normal_response);
      Store(Select(used, soft / k_n, zero), contact.effective_mass);
      Store(Select(used, scale, zero), contact.impulse_scale);
      Store(k_n1, contact.response_n1);
      Store(k_n2, contact.response_n2);
      Store(Select(used, k22 / determinant, zero), contact.tangent_mass11);
      Store(Select(used, zero - k12 / determinant, zero), contact.tangent_mass12);
      Store(Select(used, k11 / determinant, zero), contact.tangent_mass22);
      Store(Select(used, max_slip_response, zero), data.slip_response);
      Store(Select(used, one / max_slip_response, zero), contact.friction_step);
      Store(Select(is_bouncing & used, one, zero), data.bounces);
      Store(Select(is_steady, one, zero), data.steady);
    }
  }
  return MaxLane(Sqrt(max_squared));
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
template <class Real>
double PrepareContacts(const ConstraintView<Real>& constraints,
                       const ContactParameters& parameters,
                       std::span<const ContactPair> pairs, const SolverBodies& bodies) {
  return COOKBOOK_DISPATCH(Prepare<Real>)(constraints, parameters, pairs, bodies);
}
COOKBOOK_INSTANTIATE(PrepareContacts);
}  // namespace cookbook
#endif
