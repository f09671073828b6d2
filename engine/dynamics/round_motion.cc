#include "engine/dynamics/round_motion.h"

#include <algorithm>
#include <array>

#include "engine/dynamics/rotation.h"

// Four doubles are one register from AVX2 on.
#define HWY_DISABLED_TARGETS                                               \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
   HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dynamics/round_motion.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "engine/dynamics/bodies_in_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {
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
  unsigned fast = Bits(~(squared < Splat(kSmallTurnSquared)));
  for (std::size_t lane = 0; fast != 0; ++lane, fast >>= 1) {
    if ((fast & 1) == 0) continue;
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

/** Moves four bodies; `ways` has room for four. Returns as MoveRound(). */
HWY_INLINE bool MoveFour(const Motion& motion, const int* indices, double* ways) {
  std::array<RigidBody*, 4> body;
  std::array<const double*, 4> p_WB;
  std::array<const double*, 4> q_WB;
  Four radius;
  Four usual;
  Four touched{};
  Four surely_struck{};
  Four rested{};
  Four turns;  // 0 of a ball, which no turn takes from its place.
  bool is_pushed = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    body[k] = &motion.bodies[i];
    p_WB[k] = body[k]->state.p_WB.data();
    q_WB[k] = body[k]->state.q_WB.coeffs().data();
    radius[k] = body[k]->radius;
    usual[k] = std::max(body[k]->pull, body[k]->heap_pull);
    const Touch& touch = motion.touches[i];
    touched[k] = touch.bounced || touch.rested ? 1 : 0;
    surely_struck[k] = motion.is_large || touch.bounced || !touch.steady ? 1 : 0;
    rested[k] = touch.rested ? 1 : 0;
    turns[k] = body[k]->is_ball ? 0 : 2;
    is_pushed |= body[k]->is_pushed;
  }
  const Four zero{};
  const Four half = Splat(0.5);
  const Four h = Splat(motion.h);
  const Moving<double> before = GatherFour(motion.before.data(), indices);
  const Moving<double> after = GatherFour(motion.solved.data(), indices);
  const Four change = Sqrt(SquaredLength(Minus(after.v, before.v))) +
                      radius * Sqrt(SquaredLength(Minus(after.w, before.w)));
  const FourBits struck = (touched > zero) & ((surely_struck > zero) |
                                              (change > Splat(kBlow * motion.h) * usual));
  const auto choose = [&](const Vec3<double>& yes, const Vec3<double>& no) HWY_ATTR {
    return Vec3<double>{Select(struck, yes.x, no.x), Select(struck, yes.y, no.y),
                        Select(struck, yes.z, no.z)};
  };
  Vec3<double> thrown = after.v;   // What is struck.
  Vec3<double> turned = before.w;  // How what is struck turns from the start.
  if (Bits(struck) != 0) {
    const Moving<double> free = GatherFour(motion.free.data(), indices);
    const Four share = Select(rested > zero, zero, half);
    thrown = Minus(after.v, Times(share, Minus(free.v, before.v)));
    turned = choose(Plus(before.w, Minus(after.w, free.w)), before.w);
  }
  const Moving<double> mean{choose(thrown, Times(half, Plus(before.v, after.v))),
                            choose(after.w, Times(half, Plus(before.w, after.w)))};

  Four lanes[4];
  LoadFour(p_WB, lanes);
  const Vec3<double> p{lanes[0], lanes[1], lanes[2]};
  const Vec3<double> moved = Plus(p, Times(h, mean.v));
  const Four large = Splat(kLargest);
  // Compared one by one: what is not a number is not below.
  FourBits below = Abs(moved.x) < large;
  for (const Four& x : {moved.y, moved.z, after.v.x, after.v.y, after.v.z, after.w.x,
                        after.w.y, after.w.z})
    below &= Abs(x) < large;
  const bool is_sane = Bits(below) == 15;
  const Four way = Sqrt(SquaredLength(Minus(moved, p)));

  const Vec3<double> k1 = Times(h, turned);
  const Vec3<double> k4 = Times(h, after.w);
  const Vec3<double> bend = Cross(k1, k4);
  const Four twelve = Splat(12);
  const Vec3<double> phi = Minus(Times(half, Plus(k1, k4)),
                                 {bend.x / twelve, bend.y / twelve, bend.z / twelve});
  LoadFour(q_WB, lanes);
  const Quaternions q =
      Normalized(Product(ExpOf(phi), {lanes[0], lanes[1], lanes[2], lanes[3]}));
  // A turn by θ moves a point at r by 2 r sin(θ / 2) at most.
  const Four sine = Min(half * Sqrt(SquaredLength(phi)), Splat(1));
  Store(way + turns * radius * sine, ways);

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
  const Four one = Splat(1);
  Four R_low[4] = {one - (tyy + tzz), txy + twz, txz - twy, txy - twz};
  Four R_high[4] = {one - (txx + tzz), tyz + twx, txz + twy, tyz - twx};
  const Four R_last = one - (txx + tyy);
  Four places[4] = {moved.x, moved.y, moved.z, zero};
  Four turnings[4] = {q.x, q.y, q.z, q.w};
  Four velocities[4] = {after.v.x, after.v.y, after.v.z, zero};
  Four spins[4] = {after.w.x, after.w.y, after.w.z, zero};
  for (Four* four : {R_low, R_high, places, turnings, velocities, spins}) {
    Transpose4(four[0], four[1], four[2], four[3]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    BodyState& state = body[k]->state;
    Store3(places[k], state.p_WB);
    Store(turnings[k], state.q_WB.coeffs().data());
    Store3(velocities[k], state.v_WB);
    Store3(spins[k], state.w_WB);
    double* R_WB = body[k]->R_WB.data();
    Store(R_low[k], R_WB);
    Store(R_high[k], R_WB + 4);
    R_WB[8] = R_last[k];
    motion.shares[static_cast<std::size_t>(indices[k])] = struck[k] ? 1 : 0.5;
  }
  ScatterFour(mean, indices, one, motion.mean.data());
  return is_sane;
}

bool MoveAll(const Motion& motion, std::span<const int> bodies, std::span<double> ways) {
  bool is_sane = true;
  std::size_t k = 0;
  for (; k + 4 <= bodies.size(); k += 4)
    is_sane &= MoveFour(motion, &bodies[k], &ways[k]);
  if (k == bodies.size()) return is_sane;
  // Lanes without a body repeat the last: what they write is the same.
  std::array<int, 4> last;
  std::array<double, 4> ways_of_last;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    last[lane] = bodies[std::min(k + lane, bodies.size() - 1)];
  }
  is_sane &= MoveFour(motion, last.data(), ways_of_last.data());
  std::copy_n(ways_of_last.begin(), bodies.size() - k,
              ways.begin() + static_cast<std::ptrdiff_t>(k));
  return is_sane;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
HWY_EXPORT(MoveAll);

bool MoveRound(const Motion& motion, std::span<const int> bodies,
               std::span<double> ways) {
  return HWY_DYNAMIC_DISPATCH(MoveAll)(motion, bodies, ways);
}
}  // namespace cookbook
#endif
