// A vector of sixteen floats. It is a plain compiler vector if the processor has
// registers of that size (AVX-512), else two Eights: g++ 12 does not split such a vector
// by itself. Include it after hwy/highway.h, in a file that foreach_target.h includes
// repeatedly; hence the include guard that toggles.

#if defined(COOKBOOK_ENGINE_SIXTEEN_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_SIXTEEN_LANES_H_
#undef COOKBOOK_ENGINE_SIXTEEN_LANES_H_
#else
#define COOKBOOK_ENGINE_SIXTEEN_LANES_H_
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "engine/simd/eight_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3

using Sixteen = float __attribute__((vector_size(64)));
/** The result of comparing two Sixteen: all bits set in a lane where it is true. */
using SixteenBits = std::int32_t __attribute__((vector_size(64)));

HWY_INLINE Sixteen Concatenate(Eight low, Eight high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13,
                                 14, 15);
}
HWY_INLINE Eight Low(Sixteen v) {
  return __builtin_shufflevector(v, v, 0, 1, 2, 3, 4, 5, 6, 7);
}
HWY_INLINE Eight High(Sixteen v) {
  return __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15);
}

HWY_INLINE Sixteen SplatSixteen(float x) {
  return Sixteen{} + x;
}

/** Like ApplyToVectors() for Four. */
template <class Operation>
HWY_INLINE Sixteen ApplyToVectors(Sixteen a, Sixteen b, const Operation& operation) {
  const hwy::HWY_NAMESPACE::CappedTag<float, 16> tag;
  alignas(64) float x[16];
  alignas(64) float y[16];
  std::memcpy(x, &a, sizeof a);
  std::memcpy(y, &b, sizeof b);
  hwy::HWY_NAMESPACE::Store(
      operation(hwy::HWY_NAMESPACE::Load(tag, x), hwy::HWY_NAMESPACE::Load(tag, y)), tag,
      x);
  Sixteen result;
  std::memcpy(&result, x, sizeof result);
  return result;
}

HWY_INLINE Sixteen Abs(Sixteen x) {
  return reinterpret_cast<Sixteen>(reinterpret_cast<SixteenBits>(x) & INT32_MAX);
}
HWY_INLINE Sixteen Min(Sixteen a, Sixteen b) {
  return ApplyToVectors(
      a, b, [](auto x, auto y) HWY_ATTR { return hwy::HWY_NAMESPACE::Min(x, y); });
}
HWY_INLINE Sixteen Max(Sixteen a, Sixteen b) {
  return ApplyToVectors(
      a, b, [](auto x, auto y) HWY_ATTR { return hwy::HWY_NAMESPACE::Max(x, y); });
}
HWY_INLINE Sixteen Sqrt(Sixteen x) {
  return ApplyToVectors(
      x, x, [](auto v, auto) HWY_ATTR { return hwy::HWY_NAMESPACE::Sqrt(v); });
}
HWY_INLINE Sixteen Select(SixteenBits choose, Sixteen a, Sixteen b) {
  return choose ? a : b;
}
HWY_INLINE EightBits Low(SixteenBits x) {
  return __builtin_shufflevector(x, x, 0, 1, 2, 3, 4, 5, 6, 7);
}
HWY_INLINE EightBits High(SixteenBits x) {
  return __builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15);
}

#else

struct Sixteen {
  Eight low;
  Eight high;
};
/** The result of comparing two Sixteen: all bits set in a lane where it is true. */
struct SixteenBits {
  EightBits low;
  EightBits high;
};

HWY_INLINE Sixteen Concatenate(Eight low, Eight high) {
  return {low, high};
}
HWY_INLINE Eight Low(const Sixteen& v) {
  return v.low;
}
HWY_INLINE Eight High(const Sixteen& v) {
  return v.high;
}
HWY_INLINE EightBits Low(const SixteenBits& x) {
  return x.low;
}
HWY_INLINE EightBits High(const SixteenBits& x) {
  return x.high;
}

HWY_INLINE Sixteen SplatSixteen(float x) {
  return {Eight{} + x, Eight{} + x};
}

HWY_INLINE Sixteen operator+(const Sixteen& a, const Sixteen& b) {
  return {a.low + b.low, a.high + b.high};
}
HWY_INLINE Sixteen operator-(const Sixteen& a, const Sixteen& b) {
  return {a.low - b.low, a.high - b.high};
}
HWY_INLINE Sixteen operator*(const Sixteen& a, const Sixteen& b) {
  return {a.low * b.low, a.high * b.high};
}
HWY_INLINE Sixteen operator/(const Sixteen& a, const Sixteen& b) {
  return {a.low / b.low, a.high / b.high};
}
HWY_INLINE SixteenBits operator<(const Sixteen& a, const Sixteen& b) {
  return {a.low < b.low, a.high < b.high};
}
HWY_INLINE SixteenBits operator>(const Sixteen& a, const Sixteen& b) {
  return {a.low > b.low, a.high > b.high};
}
HWY_INLINE SixteenBits operator<=(const Sixteen& a, const Sixteen& b) {
  return {a.low <= b.low, a.high <= b.high};
}
HWY_INLINE SixteenBits operator&(const SixteenBits& a, const SixteenBits& b) {
  return {a.low & b.low, a.high & b.high};
}
HWY_INLINE SixteenBits operator|(const SixteenBits& a, const SixteenBits& b) {
  return {a.low | b.low, a.high | b.high};
}
HWY_INLINE SixteenBits operator~(const SixteenBits& a) {
  return {~a.low, ~a.high};
}
HWY_INLINE SixteenBits& operator&=(SixteenBits& a, const SixteenBits& b) {
  return a = a & b;
}
HWY_INLINE SixteenBits& operator|=(SixteenBits& a, const SixteenBits& b) {
  return a = a | b;
}

HWY_INLINE Sixteen Abs(const Sixteen& x) {
  return {Abs(x.low), Abs(x.high)};
}
HWY_INLINE Sixteen Min(const Sixteen& a, const Sixteen& b) {
  return {Min(a.low, b.low), Min(a.high, b.high)};
}
HWY_INLINE Sixteen Max(const Sixteen& a, const Sixteen& b) {
  return {Max(a.low, b.low), Max(a.high, b.high)};
}
HWY_INLINE Sixteen Sqrt(const Sixteen& x) {
  return {Sqrt(x.low), Sqrt(x.high)};
}
HWY_INLINE Sixteen Select(const SixteenBits& choose, const Sixteen& a, const Sixteen& b) {
  return {Select(choose.low, a.low, b.low), Select(choose.high, a.high, b.high)};
}

#endif

HWY_INLINE Sixteen LoadSixteen(const float* p) {
  return Concatenate(LoadEight(p), LoadEight(p + 8));
}
HWY_INLINE void Store(const Sixteen& v, float* p) {
  Store(Low(v), p);
  Store(High(v), p + 8);
}

/** Returns a mask whose bit k is set if lane k is true. */
HWY_INLINE unsigned Bits(const SixteenBits& x) {
  return Bits(Low(x)) | Bits(High(x)) << 8;
}

/** Rounds sixteen doubles to floats. */
HWY_INLINE Sixteen Narrow(const Four doubles[4]) {
  return Concatenate(Narrow(doubles[0], doubles[1]), Narrow(doubles[2], doubles[3]));
}

}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
