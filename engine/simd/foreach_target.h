// The head of every SIMD kernel: compiles a source file once for each SIMD target.
//
//   #define HWY_TARGET_INCLUDE "engine/…/kernel.cc"  // The path of the source file.
//   #include "engine/simd/foreach_target.h"
//   // After foreach_target.h.
//   #include "engine/simd/four_lanes.h"
//
// The source file is included again for each target, and this header with it, hence no
// include guard. The tail of a kernel is in engine/simd/dispatch.h.

/** Vectors whose size is unknown at compile time cannot be stored in arrays. */
#define COOKBOOK_SIZELESS_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

/** Registers of two doubles, as in the baseline: no faster than the baseline. */
#define COOKBOOK_NARROW_TARGETS (HWY_SSSE3 | HWY_SSE4)

// A kernel that needs other targets defines this macro first. AVX3_DL adds only integer
// instructions to AVX3.
#ifndef COOKBOOK_DISABLED_TARGETS
#define COOKBOOK_DISABLED_TARGETS \
  (COOKBOOK_SIZELESS_TARGETS | COOKBOOK_NARROW_TARGETS | HWY_AVX3_DL)
#endif
#define HWY_DISABLED_TARGETS COOKBOOK_DISABLED_TARGETS

#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "engine/simd/dispatch.h"
