// Four pairs of bodies at once, for engine code compiled once per processor target.
// Include after engine/four_lanes.h, within a file that foreach_target.h reads again and
// again; hence the guard that toggles.

#if defined(COOKBOOK_ENGINE_FOUR_BODIES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_FOUR_BODIES_H_
#undef COOKBOOK_ENGINE_FOUR_BODIES_H_
#else
#define COOKBOOK_ENGINE_FOUR_BODIES_H_
#endif

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/dynamics/contact_batch.h"
#include "engine/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {

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

HWY_INLINE void Put(const Four3& v, VectorLanes& lanes) {
  Put(v.x, lanes[0]);
  Put(v.y, lanes[1]);
  Put(v.z, lanes[2]);
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

template <class Batch>
HWY_INLINE Inertias InertiasOf(const Batch& batch) {
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

}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#endif
