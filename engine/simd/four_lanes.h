// A vector of four doubles, for engine code that is compiled once per SIMD target. It is
// a plain compiler vector, which every target supports: on narrower registers it becomes
// two vectors. Include it after hwy/highway.h, in a file that foreach_target.h includes
// repeatedly; hence the include guard that toggles.

#if defined(COOKBOOK_ENGINE_FOUR_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COOKBOOK_ENGINE_FOUR_LANES_H_
#undef COOKBOOK_ENGINE_FOUR_LANES_H_
#else
#define COOKBOOK_ENGINE_FOUR_LANES_H_
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {

using Four = double __attribute__((vector_size(32)));
/** The result of comparing two Four: all bits set in a lane where it is true. */
using FourBits = std::int64_t __attribute__((vector_size(32)));

/** A Four with the alignment of a double, over any memory made of doubles. It replaces
 std::memcpy(), which g++ 12 sometimes compiles to moves through integer registers. */
using FourInMemory [[gnu::aligned(8), gnu::may_alias]] = Four;
static_assert(alignof(FourInMemory) == 8);

HWY_INLINE Four Load(const void* p) {
  return *static_cast<const FourInMemory*>(p);
}

HWY_INLINE void Store(Four v, void* p) {
  *static_cast<FourInMemory*>(p) = v;
}

/** Returns the three numbers at `p`, and `last` in the fourth lane. */
HWY_INLINE Four Load3(const double* p, double last) {
  return Four{p[0], p[1], p[2], last};
}

HWY_INLINE Four Splat(double x) {
  return Four{x, x, x, x};
}

HWY_INLINE Four Abs(Four x) {
  return reinterpret_cast<Four>(reinterpret_cast<FourBits>(x) & INT64_MAX);
}

/** Applies `operation` to native vectors; a Four may be two of them. */
template <class Operation>
HWY_INLINE Four ApplyToVectors(Four a, Four b, const Operation& operation) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<double, 4> tag;
  alignas(32) double x[4];
  alignas(32) double y[4];
  Store(a, x);
  Store(b, y);
  for (std::size_t k = 0; k < 4; k += hn::Lanes(tag)) {
    hn::Store(operation(hn::Load(tag, x + k), hn::Load(tag, y + k)), tag, x + k);
  }
  return Load(x);
}

/** Returns the lesser in each lane; b if either is NaN. */
HWY_INLINE Four Min(Four a, Four b) {
#if HWY_ARCH_X86
  // The same result, but for AVX-512 g++ 12 needs two instructions for the comparison.
  return ApplyToVectors(
      a, b, [](auto x, auto y) HWY_ATTR { return hwy::HWY_NAMESPACE::Min(x, y); });
#else
  return a < b ? a : b;
#endif
}

/** Returns the greater in each lane; b if either is NaN. */
HWY_INLINE Four Max(Four a, Four b) {
#if HWY_ARCH_X86
  return ApplyToVectors(
      a, b, [](auto x, auto y) HWY_ATTR { return hwy::HWY_NAMESPACE::Max(x, y); });
#else
  return a > b ? a : b;
#endif
}

HWY_INLINE Four Select(FourBits choose, Four a, Four b) {
  return choose ? a : b;
}

HWY_INLINE Four Sqrt(Four x) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<double, 4> tag;
  alignas(32) double lanes[4];
  Store(x, lanes);
  for (std::size_t k = 0; k < 4; k += hn::Lanes(tag)) {
    hn::Store(hn::Sqrt(hn::Load(tag, lanes + k)), tag, lanes + k);
  }
  return Load(lanes);
}

/** Returns a mask whose bit k is set if lane k is true. */
HWY_INLINE unsigned Bits(FourBits x) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<std::int64_t, 4> tag;
  alignas(32) std::int64_t lanes[4];
  std::memcpy(lanes, &x, sizeof x);
  unsigned bits = 0;
  for (std::size_t k = 0; k < 4; k += hn::Lanes(tag)) {
    std::uint8_t some[8] = {};
    hn::StoreMaskBits(tag, hn::MaskFromVec(hn::Load(tag, lanes + k)), some);
    bits |= static_cast<unsigned>(some[0]) << k;
  }
  return bits;
}

/** Transposes the 3 × 3 matrix with the rows `in`; the fourth lanes of `out` are 0. */
HWY_INLINE void Transpose(const Four in[3], Four out[3]) {
  const Four zero{};
  const Four even = __builtin_shufflevector(in[0], in[1], 0, 4, 2, 6);
  const Four odd = __builtin_shufflevector(in[0], in[1], 1, 5, 3, 7);
  const Four last_even = __builtin_shufflevector(in[2], zero, 0, 4, 2, 6);
  const Four last_odd = __builtin_shufflevector(in[2], zero, 1, 5, 3, 7);
  out[0] = __builtin_shufflevector(even, last_even, 0, 1, 4, 5);
  out[1] = __builtin_shufflevector(odd, last_odd, 0, 1, 4, 5);
  out[2] = __builtin_shufflevector(even, last_even, 2, 3, 6, 7);
}

/** Loads the columns of a 3 × 3 matrix; the values of the fourth lanes are
 unspecified. */
HWY_INLINE void LoadColumns(const double* matrix, Four out[3]) {
  out[0] = Load(matrix);
  out[1] = Load(matrix + 3);
  const Four before_last = Load(matrix + 5);
  out[2] = __builtin_shufflevector(before_last, before_last, 1, 2, 3, 0);
}

}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
