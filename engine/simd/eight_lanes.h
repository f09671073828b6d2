// A vector of eight floats, the counterpart of Four in engine/simd/four_lanes.h. Include
// it after hwy/highway.h, in a file that foreach_target.h includes repeatedly; hence the
// include guard that toggles.

#if defined(COOKBOOK_ENGINE_EIGHT_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_EIGHT_LANES_H_
#undef COOKBOOK_ENGINE_EIGHT_LANES_H_
#else
#define COOKBOOK_ENGINE_EIGHT_LANES_H_
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "engine/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {

using Eight = float __attribute__((vector_size(32)));
/** The result of comparing two Eight: all bits set in a lane where it is true. */
using EightBits = std::int32_t __attribute__((vector_size(32)));

/** An Eight with the alignment of a float, over any memory made of floats. */
using EightInMemory [[gnu::aligned(4), gnu::may_alias]] = Eight;
static_assert(alignof(EightInMemory) == 4);

HWY_INLINE Eight LoadEight(const float* p) {
  return *reinterpret_cast<const EightInMemory*>(p);
}

HWY_INLINE void Store(Eight v, float* p) {
  *reinterpret_cast<EightInMemory*>(p) = v;
}

HWY_INLINE Eight Abs(Eight x) {
  return reinterpret_cast<Eight>(reinterpret_cast<EightBits>(x) & INT32_MAX);
}

/** Like ApplyToVectors() for Four. */
template <class Operation>
HWY_INLINE Eight ApplyToVectors(Eight a, Eight b, const Operation& operation) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<float, 8> tag;
  alignas(32) float x[8];
  alignas(32) float y[8];
  Store(a, x);
  Store(b, y);
  for (std::size_t k = 0; k < 8; k += hn::Lanes(tag)) {
    hn::Store(operation(hn::Load(tag, x + k), hn::Load(tag, y + k)), tag, x + k);
  }
  return LoadEight(x);
}

/** Returns the lesser in each lane; b if either is NaN. */
HWY_INLINE Eight Min(Eight a, Eight b) {
#if HWY_ARCH_X86
  return ApplyToVectors(
      a, b, [](auto x, auto y) HWY_ATTR { return hwy::HWY_NAMESPACE::Min(x, y); });
#else
  return a < b ? a : b;
#endif
}

/** Returns the greater in each lane; b if either is NaN. */
HWY_INLINE Eight Max(Eight a, Eight b) {
#if HWY_ARCH_X86
  return ApplyToVectors(
      a, b, [](auto x, auto y) HWY_ATTR { return hwy::HWY_NAMESPACE::Max(x, y); });
#else
  return a > b ? a : b;
#endif
}

HWY_INLINE Eight Select(EightBits choose, Eight a, Eight b) {
  return choose ? a : b;
}

HWY_INLINE Eight Sqrt(Eight x) {
  return ApplyToVectors(
      x, x, [](auto v, auto) HWY_ATTR { return hwy::HWY_NAMESPACE::Sqrt(v); });
}

/** Returns a mask whose bit k is set if lane k is true. */
HWY_INLINE unsigned Bits(EightBits x) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<std::int32_t, 8> tag;
  alignas(32) std::int32_t lanes[8];
  std::memcpy(lanes, &x, sizeof x);
  unsigned bits = 0;
  for (std::size_t k = 0; k < 8; k += hn::Lanes(tag)) {
    std::uint8_t some[8] = {};
    hn::StoreMaskBits(tag, hn::MaskFromVec(hn::Load(tag, lanes + k)), some);
    bits |= static_cast<unsigned>(some[0]) << k;
  }
  return bits;
}

using FourFloats = float __attribute__((vector_size(16)));

/** Rounds eight doubles to floats. */
HWY_INLINE Eight Narrow(Four low, Four high) {
  return __builtin_shufflevector(__builtin_convertvector(low, FourFloats),
                                 __builtin_convertvector(high, FourFloats), 0, 1, 2, 3, 4,
                                 5, 6, 7);
}

/** Transposes an 8 × 8 matrix in place. */
HWY_INLINE void Transpose8(Eight m[8]) {
  Eight a[8];
#pragma GCC unroll 4
  for (int k = 0; k < 8; k += 2) {
    a[k] = __builtin_shufflevector(m[k], m[k + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    a[k + 1] = __builtin_shufflevector(m[k], m[k + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  Eight b[8];
#pragma GCC unroll 2
  for (int k = 0; k < 8; k += 4) {
    b[k] = __builtin_shufflevector(a[k], a[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    b[k + 1] = __builtin_shufflevector(a[k], a[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    b[k + 2] = __builtin_shufflevector(a[k + 1], a[k + 3], 0, 1, 8, 9, 4, 5, 12, 13);
    b[k + 3] = __builtin_shufflevector(a[k + 1], a[k + 3], 2, 3, 10, 11, 6, 7, 14, 15);
  }
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    m[k] = __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    m[k + 4] = __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
