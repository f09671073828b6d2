#include <algorithm>
#include <array>

#include "engine/dynamics/body/rotation.h"
#include "engine/dynamics/world/integrate.h"

#define HWY_TARGET_INCLUDE "engine/dynamics/world/integrate_simd.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/dynamics/solver/solver_bodies_simd.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

// Sums and products in the order in which Eigen has them: a body moves by the same bits
// here as alone.

HWY_INLINE Four SquaredLength(const Vec3<double>& a) {
  return a.x * a.x + (a.y * a.y + a.z * a.z);
}

struct Quaternions {
  Four x, y, z, w;
};

HWY_INLINE Quaternions Product(const Quaternions& a, const Quaternions& b) {
  return {(a.w * b.x + a.y * b.z) - (a.z * b.y - a.x * b.w),
          (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z),
          (a.w * b.z - a.y * b.x) + (a.z * b.w + a.x * b.y),
          (a.w * b.w - a.y * b.y) - (a.z * b.z + a.x * b.x)};
}

HWY_INLINE Quaternions Normalized(const Quaternions& q) {
  const Four length = Sqrt((q.x * q.x + q.z * q.z) + (q.y * q.y + q.w * q.w));
  return {q.x / length, q.y / length, q.z / length, q.w / length};
}

/** As Exp(). */
HWY_INLINE Quaternions ExpOf(const Vec3<double>& phi) {
  const Four squared = SquaredLength(phi);
  Four s =
      Splat(0.5) + squared * (Splat(-1.0 / 48) +
                              squared * (Splat(1.0 / 3840) - squared / Splat(645120)));
  Four c =
      Splat(1) +
      squared * (Splat(-1.0 / 8) +
                 squared * (Splat(1.0 / 384) +
                            squared * (Splat(-1.0 / 46080) + squared / Splat(10321920))));
  Quaternions turn{s * phi.x, s * phi.y, s * phi.z, c};
  const FourBits small = squared < Splat(kSmallAngleSquared);
  const unsigned is_small = Bits(small);
  for (std::size_t lane = 0; lane < 4 && is_small != 15; ++lane) {
    if ((is_small >> lane & 1) != 0) continue;
    const Eigen::Quaterniond exact = Exp({phi.x[lane], phi.y[lane], phi.z[lane]});
    turn.x[lane] = exact.x();
    turn.y[lane] = exact.y();
    turn.z[lane] = exact.z();
    turn.w[lane] = exact.w();
  }
  return turn;
}

HWY_INLINE void Store3(Four v, Eigen::Vector3d& to) {
  to = {v[0], v[1], v[2]};
}

/** Moves four bodies by `way_W` and turns them by `phi_W`. Fills `ways` with the Travel()
 of each and returns where they are. */
HWY_INLINE Vec3<double> Displace(const std::array<RigidBody*, 4>& body,
                                 const Vec3<double>& way_W, const Vec3<double>& phi_W,
                                 double* ways) {
  std::array<const double*, 4> p_WB;
  std::array<const double*, 4> q_WB;
  Four reach;  // 0 of a ball, which no turn takes from its place.
  for (std::size_t k = 0; k < 4; ++k) {
    p_WB[k] = body[k]->state.p_WB.data();
    q_WB[k] = body[k]->state.q_WB.coeffs().data();
    reach[k] = body[k]->is_sphere ? 0 : 2 * body[k]->radius;
  }
  Four lanes[4];
  LoadFour(p_WB, lanes);
  const Vec3<double> p{lanes[0], lanes[1], lanes[2]};
  const Vec3<double> moved = Plus(p, way_W);
  LoadFour(q_WB, lanes);
  const Quaternions q =
      Normalized(Product(ExpOf(phi_W), {lanes[0], lanes[1], lanes[2], lanes[3]}));
  // A turn by θ moves a point at r by 2 r sin(θ / 2) at most.
  const Four sine = Min(Splat(0.5) * Sqrt(SquaredLength(phi_W)), Splat(1));
  Store(Sqrt(SquaredLength(Minus(moved, p))) + reach * sine, ways);

  const Four zero{};
  const Four one = Splat(1);
  const Four tx = q.x + q.x;
  const Four ty = q.y + q.y;
  const Four tz = q.z + q.z;
  const Four twx = tx * q.w;
  const Four twy = ty * q.w;
  const Four twz = tz * q.w;
  const Four txx = tx * q.x;
  const Four txy = ty * q.x;
  const Four txz = tz * q.x;
  const Four tyy = ty * q.y;
  const Four tyz = tz * q.y;
  const Four tzz = tz * q.z;
  Four R_low[4] = {one - (tyy + tzz), txy + twz, txz - twy, txy - twz};
  Four R_high[4] = {one - (txx + tzz), tyz + twx, txz + twy, tyz - twx};
  const Four R_last = one - (txx + tyy);
  Four places[4] = {moved.x, moved.y, moved.z, zero};
  Four turnings[4] = {q.x, q.y, q.z, q.w};
  for (Four* four : {R_low, R_high, places, turnings}) {
    Transpose4(four[0], four[1], four[2], four[3]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    Store3(places[k], body[k]->state.p_WB);
    Store(turnings[k], body[k]->state.q_WB.coeffs().data());
    double* R_WB = body[k]->R_WB.data();
    Store(R_low[k], R_WB);
    Store(R_high[k], R_WB + 4);
    R_WB[8] = R_last[k];
  }
  return moved;
}

/** Moves four bodies; `ways` has room for four. Returns as MoveRound(). */
HWY_INLINE bool MoveFour(const Motion& motion, const int* indices, double* ways) {
  std::array<RigidBody*, 4> body;
  Four radius;
  Four usual;
  Four touched{};
  Four surely_struck{};
  Four rested{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    body[k] = &motion.bodies[i];
    radius[k] = body[k]->radius;
    usual[k] = std::max(body[k]->load, body[k]->island_load);
    const Touch& touch = motion.touches[i];
    touched[k] = touch.bounced || touch.rested ? 1 : 0;
    surely_struck[k] = touch.bounced || !touch.steady ? 1 : 0;
    rested[k] = touch.rested ? 1 : 0;
  }
  const Four zero{};
  const Four half = Splat(0.5);
  const Four h = Splat(motion.h);
  const Moving<double> before = GatherFour(motion.before.data(), indices);
  const Moving<double> after = GatherFour(motion.solved.data(), indices);
  const Four change = Sqrt(SquaredLength(Minus(after.v, before.v))) +
                      radius * Sqrt(SquaredLength(Minus(after.w, before.w)));
  const FourBits struck =
      (touched > zero) &
      ((surely_struck > zero) | (change > Splat(kImpactFactor * motion.h) * usual));
  const auto choose = [&](const Vec3<double>& yes, const Vec3<double>& no) HWY_ATTR {
    return Vec3<double>{Select(struck, yes.x, no.x), Select(struck, yes.y, no.y),
                        Select(struck, yes.z, no.z)};
  };
  Vec3<double> thrown = after.v;   // What is struck.
  Vec3<double> turned = before.w;  // How all turn from the start.
  if (Bits(struck) != 0) {
    const Moving<double> free = GatherFour(motion.free.data(), indices);
    const Four share = Select(rested > zero, zero, half);
    thrown = Minus(after.v, Times(share, Minus(free.v, before.v)));
    turned = choose(Plus(before.w, Minus(after.w, free.w)), before.w);
  }
  const Moving<double> mean{choose(thrown, Times(half, Plus(before.v, after.v))),
                            choose(after.w, Times(half, Plus(before.w, after.w)))};
  const Vec3<double> k1 = Times(h, turned);
  const Vec3<double> k4 = Times(h, after.w);
  const Vec3<double> bend = Cross(k1, k4);
  const Four twelve = Splat(12);
  const Vec3<double> phi = Minus(Times(half, Plus(k1, k4)),
                                 {bend.x / twelve, bend.y / twelve, bend.z / twelve});
  const Vec3<double> p = Displace(body, Times(h, mean.v), phi, ways);

  Four velocities[4] = {after.v.x, after.v.y, after.v.z, zero};
  Four spins[4] = {after.w.x, after.w.y, after.w.z, zero};
  Transpose4(velocities[0], velocities[1], velocities[2], velocities[3]);
  Transpose4(spins[0], spins[1], spins[2], spins[3]);
  for (std::size_t k = 0; k < 4; ++k) {
    Store3(velocities[k], body[k]->state.v_WB);
    Store3(spins[k], body[k]->state.w_WB);
  }
  ScatterFour(mean, indices, Splat(1), motion.mean.data());

  // Each by itself: what is not a number is below nothing.
  const Four large = Splat(kLargest);
  FourBits below = Abs(p.x) < large;
  for (const Four& x :
       {p.y, p.z, after.v.x, after.v.y, after.v.z, after.w.x, after.w.y, after.w.z}) {
    below &= Abs(x) < large;
  }
  return Bits(below) == 15;
}

/** Displaces four bodies; `ways` has room for four. */
HWY_INLINE void ShiftFour(std::span<RigidBody> bodies, const Velocity* moves,
                          const int* indices, double* ways) {
  std::array<RigidBody*, 4> body;
  for (std::size_t k = 0; k < 4; ++k)
    body[k] = &bodies[static_cast<std::size_t>(indices[k])];
  const Moving<double> move = GatherFour(moves, indices);
  Displace(body, move.v, move.w, ways);
}

/** Calls `work(indices, ways)` for four bodies after the other. */
template <class Work>
HWY_INLINE void FourByFour(std::span<const int> bodies, std::span<double> ways,
                           const Work& work) {
  std::size_t k = 0;
  for (; k + 4 <= bodies.size(); k += 4) work(&bodies[k], &ways[k]);
  if (k == bodies.size()) return;
  // Lanes without a body repeat the last: what they write is the same.
  std::array<int, 4> last;
  std::array<double, 4> ways_of_last;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    last[lane] = bodies[std::min(k + lane, bodies.size() - 1)];
  }
  work(last.data(), ways_of_last.data());
  std::copy_n(ways_of_last.begin(), bodies.size() - k,
              ways.begin() + static_cast<std::ptrdiff_t>(k));
}

bool MoveAll(const Motion& motion, std::span<const int> bodies, std::span<double> ways) {
  bool is_sane = true;
  FourByFour(bodies, ways, [&](const int* four, double* four_ways) HWY_ATTR {
    is_sane &= MoveFour(motion, four, four_ways);
  });
  return is_sane;
}

void ShiftAll(std::span<RigidBody> bodies, std::span<const Velocity> moves,
              std::span<const int> some, std::span<double> ways) {
  FourByFour(some, ways, [&](const int* four, double* four_ways) HWY_ATTR {
    ShiftFour(bodies, moves.data(), four, four_ways);
  });
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
bool MoveRound(const Motion& motion, std::span<const int> bodies,
               std::span<double> ways) {
  return COOKBOOK_DISPATCH(MoveAll)(motion, bodies, ways);
}

void Shift(std::span<RigidBody> bodies, std::span<const Velocity> moves,
           std::span<const int> some, std::span<double> ways) {
  COOKBOOK_DISPATCH(ShiftAll)(bodies, moves, some, ways);
}
}  // namespace cookbook
#endif
