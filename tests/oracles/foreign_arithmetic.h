#pragma once

#include <cfenv>
#include <limits>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace touchstone {

/** Rounds upwards from now on and, where the processor is known, flushes denormal numbers
 to zero. */
inline void SetForeignArithmetic() {
  std::fesetround(FE_UPWARD);
#ifdef __SSE2__
  constexpr unsigned kFlushToZero = 0x8000;
  constexpr unsigned kDenormalsAreZero = 0x0040;
  _mm_setcsr(_mm_getcsr() | kFlushToZero | kDenormalsAreZero);
#endif
}

/** Returns whether sums are rounded to nearest and denormal numbers are kept. */
inline bool IsArithmeticStandard() {
  // Volatile, so that the compiler does not compute in its own arithmetic.
  volatile double one = 1;
  volatile double tiny = std::numeric_limits<double>::min();
  volatile double half_ulp = 0x1p-54;
  const volatile double sum = one + half_ulp;
  const volatile double halved = tiny / 2;
  return std::fegetround() == FE_TONEAREST && sum == 1 && halved != 0;
}

}  // namespace touchstone
