// Pairs of bodies, one a lane, for engine code compiled once per processor target: four
// by doubles, sixteen by floats. Include after engine/simd/sixteen_lanes.h, within a file
// that foreach_target.h reads again and again; hence the guard that toggles.

#if defined(COOKBOOK_ENGINE_BODIES_IN_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_BODIES_IN_LANES_H_
#undef COOKBOOK_ENGINE_BODIES_IN_LANES_H_
#else
#define COOKBOOK_ENGINE_BODIES_IN_LANES_H_
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/simd/four_lanes.h"
#include "engine/simd/sixteen_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook {
namespace HWY_NAMESPACE {

/** A register of numbers. */
template <class Real>
using Vec = std::conditional_t<std::is_same_v<Real, float>, Sixteen, Four>;
/** What comparing two of them gives. */
template <class Real>
using VecBits = std::conditional_t<std::is_same_v<Real, float>, SixteenBits, FourBits>;

/** Returns x in every lane. */
template <class Real>
HWY_INLINE Vec<Real> All(double x) {
  if constexpr (std::is_same_v<Real, float>) {
    return SplatSixteen(static_cast<float>(x));
  } else {
    return Splat(x);
  }
}

template <class Real>
struct Vec3 {
  Vec<Real> x;
  Vec<Real> y;
  Vec<Real> z;
};

HWY_INLINE Four At(const Lanes<double>& lanes) {
  return Load(lanes.data());
}
HWY_INLINE Sixteen At(const Lanes<float>& lanes) {
  return LoadSixteen(lanes.data());
}
template <class Real>
HWY_INLINE Vec3<Real> At(const VectorLanes<Real>& lanes) {
  return {At(lanes[0]), At(lanes[1]), At(lanes[2])};
}
HWY_INLINE void Put(Four v, Lanes<double>& lanes) {
  Store(v, lanes.data());
}
HWY_INLINE void Put(Sixteen v, Lanes<float>& lanes) {
  Store(v, lanes.data());
}

/** How many Four fill a register. */
template <class Real>
inline constexpr std::size_t kFours = kLanes<Real> / 4;

/** Writes four doubles as the four lanes from 4 · `four` on. */
HWY_INLINE void PutFour(Four v, std::size_t, Lanes<double>& lanes) {
  Store(v, lanes.data());
}
HWY_INLINE void PutFour(Four v, std::size_t four, Lanes<float>& lanes) {
  const FourFloats narrow = __builtin_convertvector(v, FourFloats);
  std::memcpy(lanes.data() + 4 * four, &narrow, sizeof narrow);
}
template <class Real>
HWY_INLINE void PutFour(const Vec3<double>& v, std::size_t four,
                        VectorLanes<Real>& lanes) {
  PutFour(v.x, four, lanes[0]);
  PutFour(v.y, four, lanes[1]);
  PutFour(v.z, four, lanes[2]);
}

/** Returns the four lanes from 4 · `four` on. */
HWY_INLINE Four FourAt(const Lanes<float>& lanes, std::size_t four) {
  FourFloats narrow;
  std::memcpy(&narrow, lanes.data() + 4 * four, sizeof narrow);
  return __builtin_convertvector(narrow, Four);
}
HWY_INLINE Vec3<double> FourAt(const VectorLanes<float>& lanes, std::size_t four) {
  return {FourAt(lanes[0], four), FourAt(lanes[1], four), FourAt(lanes[2], four)};
}

template <class Real>
HWY_INLINE Vec<Real> Dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
HWY_INLINE Vec3<Real> Cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
HWY_INLINE Vec3<Real> Plus(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
HWY_INLINE Vec3<Real> Minus(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
HWY_INLINE Vec3<Real> Times(Vec<Real> s, const Vec3<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
struct Tensor {
  Vec<Real> xx, xy, xz, yy, yz, zz;
};
template <class Real>
HWY_INLINE Tensor<Real> At(const TensorLanes<Real>& lanes) {
  return {At(lanes[0]), At(lanes[1]), At(lanes[2]),
          At(lanes[3]), At(lanes[4]), At(lanes[5])};
}
template <class Real>
HWY_INLINE Vec3<Real> Times(const Tensor<Real>& t, const Vec3<Real>& a) {
  return {t.xx * a.x + t.xy * a.y + t.xz * a.z, t.xy * a.x + t.yy * a.y + t.yz * a.z,
          t.xz * a.x + t.yz * a.y + t.zz * a.z};
}

/** The velocities of bodies. */
template <class Real>
struct Moving {
  Vec3<Real> v;
  Vec3<Real> w;
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

/** Returns the velocities of the four bodies from `bodies` on. */
HWY_INLINE Moving<double> GatherFour(const Velocity* velocities, const int* bodies) {
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

HWY_INLINE Moving<double> Gather(const Velocity* velocities,
                                 const BodyLanes<double>& bodies) {
  return GatherFour(velocities, bodies.data());
}
HWY_INLINE Moving<float> Gather(const SingleVelocity* velocities,
                                const BodyLanes<float>& bodies) {
  Eight low[8];
  Eight high[8];
  for (std::size_t k = 0; k < 8; ++k) {
    low[k] = LoadEight(velocities[bodies[k]].numbers.data());
    high[k] = LoadEight(velocities[bodies[k + 8]].numbers.data());
  }
  Transpose8(low);
  Transpose8(high);
  return {{Beside(low[0], high[0]), Beside(low[1], high[1]), Beside(low[2], high[2])},
          {Beside(low[3], high[3]), Beside(low[4], high[4]), Beside(low[5], high[5])}};
}

/** Writes the velocities of four bodies, those that move: several threads may read one
 that does not. */
HWY_INLINE void ScatterFour(const Moving<double>& moving, const int* bodies,
                            Four inverse_mass, Velocity* velocities) {
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

HWY_INLINE void Scatter(const Moving<double>& moving, const BodyLanes<double>& bodies,
                        const Lanes<double>& inverse_mass, Velocity* velocities) {
  ScatterFour(moving, bodies.data(), At(inverse_mass), velocities);
}
HWY_INLINE void Scatter(const Moving<float>& moving, const BodyLanes<float>& bodies,
                        const Lanes<float>& inverse_mass, SingleVelocity* velocities) {
  const auto& [v, w] = moving;
  Eight low[8] = {Low(v.x), Low(v.y), Low(v.z), Low(w.x), Low(w.y), Low(w.z), {}, {}};
  Eight high[8] = {High(v.x), High(v.y), High(v.z), High(w.x),
                   High(w.y), High(w.z), {},        {}};
  Transpose8(low);
  Transpose8(high);
  for (std::size_t k = 0; k < 8; ++k) {
    if (inverse_mass[k] != 0) Store(low[k], velocities[bodies[k]].numbers.data());
    if (inverse_mass[k + 8] != 0)
      Store(high[k], velocities[bodies[k + 8]].numbers.data());
  }
}

template <class Real>
HWY_INLINE Vec3<Real> RelativeVelocity(const Moving<Real>& A, const Moving<Real>& B,
                                       const Vec3<Real>& r_A, const Vec3<Real>& r_B) {
  return Minus(Plus(B.v, Cross(B.w, r_B)), Plus(A.v, Cross(A.w, r_A)));
}

/** How the bodies of some pairs move. In single precision as the centre of A sees it:
 what the two have in common of their velocities, not of their spins, is taken off before
 anything is rounded. */
template <class Real>
struct Pairs {
  Moving<Real> A;
  Moving<Real> B;

  /** Returns how the point of B moves against that of A. [m/s] */
  HWY_INLINE Vec3<Real> At(const Vec3<Real>& r_A, const Vec3<Real>& r_B) const {
    return RelativeVelocity(A, B, r_A, r_B);
  }
};

template <class Real>
HWY_INLINE Pairs<Real> PairsOf(const Velocity* velocities, const BodyLanes<Real>& A,
                               const BodyLanes<Real>& B) {
  if constexpr (std::is_same_v<Real, double>) {
    return {Gather(velocities, A), Gather(velocities, B)};
  } else {
    Four v_AB[3][4];
    Four w_A[3][4];
    Four w_B[3][4];
    for (std::size_t k = 0; k < 4; ++k) {
      const Moving<double> a = GatherFour(velocities, A.data() + 4 * k);
      const Moving<double> b = GatherFour(velocities, B.data() + 4 * k);
      const auto put = [&](const Vec3<double>& v, Four to[3][4]) HWY_ATTR {
        to[0][k] = v.x;
        to[1][k] = v.y;
        to[2][k] = v.z;
      };
      put(Minus(b.v, a.v), v_AB);
      put(a.w, w_A);
      put(b.w, w_B);
    }
    const auto narrow = [](const Four from[3][4]) HWY_ATTR {
      return Vec3<float>{Narrow(from[0]), Narrow(from[1]), Narrow(from[2])};
    };
    return {Moving<float>{{}, narrow(w_A)}, Moving<float>{narrow(v_AB), narrow(w_B)}};
  }
}

/** What resists the impulses of a batch. */
template <class Real>
struct Inertias {
  Vec<Real> mass_A;
  Vec<Real> mass_B;
  Tensor<Real> tensor_A;
  Tensor<Real> tensor_B;
};

/** Returns it of a batch of such numbers. */
template <class Real, class Batch>
HWY_INLINE Inertias<Real> InertiasOf(const Batch& batch) {
  return {At(batch.inverse_mass_A), At(batch.inverse_mass_B), At(batch.inverse_inertia_A),
          At(batch.inverse_inertia_B)};
}

/** Applies J to B and −J to A. */
template <class Real>
HWY_INLINE void Apply(const Vec3<Real>& J, const Vec3<Real>& r_A, const Vec3<Real>& r_B,
                      const Inertias<Real>& m, Moving<Real>& A, Moving<Real>& B) {
  A.v = Minus(A.v, Times(m.mass_A, J));
  A.w = Minus(A.w, Times(m.tensor_A, Cross(r_A, J)));
  B.v = Plus(B.v, Times(m.mass_B, J));
  B.w = Plus(B.w, Times(m.tensor_B, Cross(r_B, J)));
}

/** What several impulses of pairs make together. */
template <class Real>
struct Wrenches {
  Vec3<Real> J{};    ///< On B, the opposite on A. [N s]
  Vec3<Real> L_A{};  ///< The moment of it about the centre of A. [N m s]
  Vec3<Real> L_B{};

  HWY_INLINE void Add(const Vec3<Real>& impulse, const Vec3<Real>& r_A,
                      const Vec3<Real>& r_B) {
    J = Plus(J, impulse);
    L_A = Plus(L_A, Cross(r_A, impulse));
    L_B = Plus(L_B, Cross(r_B, impulse));
  }
};

/** Applies them. */
template <class Real>
HWY_INLINE void Apply(const Wrenches<Real>& all, const Inertias<Real>& m, Moving<Real>& A,
                      Moving<Real>& B) {
  A.v = Minus(A.v, Times(m.mass_A, all.J));
  A.w = Minus(A.w, Times(m.tensor_A, all.L_A));
  B.v = Plus(B.v, Times(m.mass_B, all.J));
  B.w = Plus(B.w, Times(m.tensor_B, all.L_B));
}

HWY_INLINE double Greatest(Four v) {
  return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}
HWY_INLINE double Greatest(const Sixteen& v) {
  const Eight half = Max(Low(v), High(v));
  const Eight quarter =
      Max(half, __builtin_shufflevector(half, half, 4, 5, 6, 7, 0, 1, 2, 3));
  return std::max({quarter[0], quarter[1], quarter[2], quarter[3]});
}

// What is read of four things at once.

/** Returns what the first four numbers are of each of four things. */
HWY_INLINE void LoadFour(const std::array<const double*, 4>& from, Four to[4]) {
  for (std::size_t lane = 0; lane < 4; ++lane) to[lane] = Load(from[lane]);
  Transpose4(to[0], to[1], to[2], to[3]);
}

/** Returns the inverse mass of four bodies and fills their tensors. */
HWY_INLINE Four LoadInertias(const std::array<const InverseInertia*, 4>& from,
                             Tensor<double>& tensor) {
  static_assert(offsetof(InverseInertia, mass) == 6 * sizeof(double));
  Four low[4];
  Four high[4];
  for (std::size_t k = 0; k < 4; ++k) {
    const double* numbers = from[k]->tensor_W.data();
    low[k] = Load(numbers);
    high[k] = Load(numbers + 4);
  }
  Transpose4(low[0], low[1], low[2], low[3]);
  Transpose4(high[0], high[1], high[2], high[3]);
  tensor = {low[0], low[1], low[2], low[3], high[0], high[1]};
  return high[2];
}

}  // namespace HWY_NAMESPACE
}  // namespace cookbook
HWY_AFTER_NAMESPACE();

#endif
