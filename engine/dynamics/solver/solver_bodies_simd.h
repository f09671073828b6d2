// Velocities and inertias of pairs of bodies, one pair in each lane, for engine code that
// is compiled once per SIMD target: four pairs in doubles, sixteen in floats. Include it
// after engine/simd/foreach_target.h, in a file that foreach_target.h includes
// repeatedly; hence the include guard that toggles.

#if defined(COOKBOOK_ENGINE_SOLVER_BODIES_SIMD_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_SOLVER_BODIES_SIMD_H_
#undef COOKBOOK_ENGINE_SOLVER_BODIES_SIMD_H_
#else
#define COOKBOOK_ENGINE_SOLVER_BODIES_SIMD_H_
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

/** A vector of numbers, one for each lane. */
template <class Real>
using Vec = std::conditional_t<std::is_same_v<Real, float>, Sixteen, Four>;
/** The result of comparing two Vec: all bits set in a lane where it is true. */
template <class Real>
using VecBits = std::conditional_t<std::is_same_v<Real, float>, SixteenBits, FourBits>;

/** Returns x in every lane. */
template <class Real>
HWY_INLINE Vec<Real> Splat(double x) {
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

HWY_INLINE Four Load(const Lanes<double>& lanes) {
  return Load(lanes.data());
}
HWY_INLINE Sixteen Load(const Lanes<float>& lanes) {
  return LoadSixteen(lanes.data());
}
template <class Real>
HWY_INLINE Vec3<Real> Load(const VectorLanes<Real>& lanes) {
  return {Load(lanes[0]), Load(lanes[1]), Load(lanes[2])};
}
HWY_INLINE void Store(Four v, Lanes<double>& lanes) {
  Store(v, lanes.data());
}
HWY_INLINE void Store(Sixteen v, Lanes<float>& lanes) {
  Store(v, lanes.data());
}

/** Number of Fours in a Vec<Real>. */
template <class Real>
inline constexpr std::size_t kFours = kLanes<Real> / 4;

/** Stores four doubles in the four lanes that start at 4 · `four`. */
HWY_INLINE void StoreFour(Four v, std::size_t, Lanes<double>& lanes) {
  Store(v, lanes.data());
}
HWY_INLINE void StoreFour(Four v, std::size_t four, Lanes<float>& lanes) {
  const FourFloats narrow = __builtin_convertvector(v, FourFloats);
  std::memcpy(lanes.data() + 4 * four, &narrow, sizeof narrow);
}
template <class Real>
HWY_INLINE void StoreFour(const Vec3<double>& v, std::size_t four,
                          VectorLanes<Real>& lanes) {
  StoreFour(v.x, four, lanes[0]);
  StoreFour(v.y, four, lanes[1]);
  StoreFour(v.z, four, lanes[2]);
}

/** Loads the four lanes that start at 4 · `four`. */
HWY_INLINE Four LoadFour(const Lanes<float>& lanes, std::size_t four) {
  FourFloats narrow;
  std::memcpy(&narrow, lanes.data() + 4 * four, sizeof narrow);
  return __builtin_convertvector(narrow, Four);
}
HWY_INLINE Vec3<double> LoadFour(const VectorLanes<float>& lanes, std::size_t four) {
  return {LoadFour(lanes[0], four), LoadFour(lanes[1], four), LoadFour(lanes[2], four)};
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
HWY_INLINE Tensor<Real> Load(const TensorLanes<Real>& lanes) {
  return {Load(lanes[0]), Load(lanes[1]), Load(lanes[2]),
          Load(lanes[3]), Load(lanes[4]), Load(lanes[5])};
}
template <class Real>
HWY_INLINE Vec3<Real> Times(const Tensor<Real>& t, const Vec3<Real>& a) {
  return {t.xx * a.x + t.xy * a.y + t.xz * a.z, t.xy * a.x + t.yy * a.y + t.yz * a.z,
          t.xz * a.x + t.yz * a.y + t.zz * a.z};
}

/** The velocities of bodies, one in each lane. */
template <class Real>
struct BodyVelocities {
  Vec3<Real> v;
  Vec3<Real> w;
};

/** Transposes the 4 × 4 matrix with the rows a, b, c, d. */
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

/** Returns the velocities of the four bodies whose indices start at `bodies`. */
HWY_INLINE BodyVelocities<double> GatherFour(const Velocity* velocities,
                                             const int* bodies) {
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

HWY_INLINE BodyVelocities<double> Gather(const Velocity* velocities,
                                         const BodyLanes<double>& bodies) {
  return GatherFour(velocities, bodies.data());
}
HWY_INLINE BodyVelocities<float> Gather(const SingleVelocity* velocities,
                                        const BodyLanes<float>& bodies) {
  Eight low[8];
  Eight high[8];
  for (std::size_t k = 0; k < 8; ++k) {
    low[k] = LoadEight(velocities[bodies[k]].numbers.data());
    high[k] = LoadEight(velocities[bodies[k + 8]].numbers.data());
  }
  Transpose8(low);
  Transpose8(high);
  return {{Concatenate(low[0], high[0]), Concatenate(low[1], high[1]),
           Concatenate(low[2], high[2])},
          {Concatenate(low[3], high[3]), Concatenate(low[4], high[4]),
           Concatenate(low[5], high[5])}};
}

/** Writes the velocities of four bodies. Skips static bodies, which other threads may
 read at the same time. */
HWY_INLINE void ScatterFour(const BodyVelocities<double>& velocity, const int* bodies,
                            Four inverse_mass, Velocity* velocities) {
  Four low[4] = {velocity.v.x, velocity.v.y, velocity.v.z, velocity.w.x};
  Four high[4] = {velocity.w.y, velocity.w.z, Four{}, Four{}};
  Transpose4(low[0], low[1], low[2], low[3]);
  Transpose4(high[0], high[1], high[2], high[3]);
  for (std::size_t k = 0; k < 4; ++k) {
    if (inverse_mass[k] == 0) continue;
    double* numbers = velocities[bodies[k]].v.data();
    Store(low[k], numbers);
    Store(high[k], numbers + 4);
  }
}

HWY_INLINE void Scatter(const BodyVelocities<double>& velocity,
                        const BodyLanes<double>& bodies,
                        const Lanes<double>& inverse_mass, Velocity* velocities) {
  ScatterFour(velocity, bodies.data(), Load(inverse_mass), velocities);
}
HWY_INLINE void Scatter(const BodyVelocities<float>& velocity,
                        const BodyLanes<float>& bodies, const Lanes<float>& inverse_mass,
                        SingleVelocity* velocities) {
  const auto& [v, w] = velocity;
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

/** Returns the velocity of the point of B at `r_B` relative to the point of A at `r_A`.
 */
template <class Real>
HWY_INLINE Vec3<Real> RelativeVelocity(const BodyVelocities<Real>& A,
                                       const BodyVelocities<Real>& B,
                                       const Vec3<Real>& r_A, const Vec3<Real>& r_B) {
  return Minus(Plus(B.v, Cross(B.w, r_B)), Plus(A.v, Cross(A.w, r_A)));
}

/** The velocities of the bodies of some pairs. In single precision they are relative to
 the linear velocity of A, which is subtracted in double precision: the common velocity of
 the two then causes no rounding error. The spins are not relative. */
template <class Real>
struct PairVelocities {
  BodyVelocities<Real> A;
  BodyVelocities<Real> B;

  /** Returns the velocity of the point of B relative to the point of A. [m/s] */
  HWY_INLINE Vec3<Real> RelativeAt(const Vec3<Real>& r_A, const Vec3<Real>& r_B) const {
    return RelativeVelocity(A, B, r_A, r_B);
  }
};

template <class Real>
HWY_INLINE PairVelocities<Real> GatherPairVelocities(const Velocity* velocities,
                                                     const BodyLanes<Real>& A,
                                                     const BodyLanes<Real>& B) {
  if constexpr (std::is_same_v<Real, double>) {
    return {Gather(velocities, A), Gather(velocities, B)};
  } else {
    Four v_AB[3][4];
    Four w_A[3][4];
    Four w_B[3][4];
    for (std::size_t k = 0; k < 4; ++k) {
      const BodyVelocities<double> a = GatherFour(velocities, A.data() + 4 * k);
      const BodyVelocities<double> b = GatherFour(velocities, B.data() + 4 * k);
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
    return {BodyVelocities<float>{{}, narrow(w_A)},
            BodyVelocities<float>{narrow(v_AB), narrow(w_B)}};
  }
}

/** The inverse masses and inertia tensors of the bodies of some pairs. */
template <class Real>
struct InverseInertias {
  Vec<Real> inverse_mass_A;
  Vec<Real> inverse_mass_B;
  Tensor<Real> inverse_inertia_A;
  Tensor<Real> inverse_inertia_B;
};

/** Loads those of a batch of contact or position constraints. */
template <class Real, class Batch>
HWY_INLINE InverseInertias<Real> LoadInverseInertias(const Batch& batch) {
  return {Load(batch.inverse_mass_A), Load(batch.inverse_mass_B),
          Load(batch.inverse_inertia_A), Load(batch.inverse_inertia_B)};
}

/** Applies the impulse J to B at `r_B`, and −J to A at `r_A`. */
template <class Real>
HWY_INLINE void ApplyImpulse(const Vec3<Real>& J, const Vec3<Real>& r_A,
                             const Vec3<Real>& r_B, const InverseInertias<Real>& m,
                             BodyVelocities<Real>& A, BodyVelocities<Real>& B) {
  A.v = Minus(A.v, Times(m.inverse_mass_A, J));
  A.w = Minus(A.w, Times(m.inverse_inertia_A, Cross(r_A, J)));
  B.v = Plus(B.v, Times(m.inverse_mass_B, J));
  B.w = Plus(B.w, Times(m.inverse_inertia_B, Cross(r_B, J)));
}

/** The sum of several impulses of each pair. */
template <class Real>
struct ImpulseSum {
  Vec3<Real> J{};    ///< On B; −J acts on A. [N s]
  Vec3<Real> L_A{};  ///< Moment of J about the centre of A. [N m s]
  Vec3<Real> L_B{};  ///< Moment of J about the centre of B. [N m s]

  HWY_INLINE void Add(const Vec3<Real>& impulse, const Vec3<Real>& r_A,
                      const Vec3<Real>& r_B) {
    J = Plus(J, impulse);
    L_A = Plus(L_A, Cross(r_A, impulse));
    L_B = Plus(L_B, Cross(r_B, impulse));
  }
};

/** Applies the sum to B, and its opposite to A. */
template <class Real>
HWY_INLINE void ApplyImpulse(const ImpulseSum<Real>& sum, const InverseInertias<Real>& m,
                             BodyVelocities<Real>& A, BodyVelocities<Real>& B) {
  A.v = Minus(A.v, Times(m.inverse_mass_A, sum.J));
  A.w = Minus(A.w, Times(m.inverse_inertia_A, sum.L_A));
  B.v = Plus(B.v, Times(m.inverse_mass_B, sum.J));
  B.w = Plus(B.w, Times(m.inverse_inertia_B, sum.L_B));
}

/** Returns the greatest lane. */
HWY_INLINE double MaxLane(Four v) {
  return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}
HWY_INLINE double MaxLane(const Sixteen& v) {
  const Eight half = Max(Low(v), High(v));
  const Eight quarter =
      Max(half, __builtin_shufflevector(half, half, 4, 5, 6, 7, 0, 1, 2, 3));
  return std::max({quarter[0], quarter[1], quarter[2], quarter[3]});
}

/** Loads four doubles from each of four addresses; to[k] contains number k of each. */
HWY_INLINE void LoadTransposed(const std::array<const double*, 4>& from, Four to[4]) {
  for (std::size_t lane = 0; lane < 4; ++lane) to[lane] = Load(from[lane]);
  Transpose4(to[0], to[1], to[2], to[3]);
}

/** Returns the inverse masses of four bodies, and fills their inverse inertia tensors. */
HWY_INLINE Four GatherInverseInertias(const std::array<const InverseInertia*, 4>& from,
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
