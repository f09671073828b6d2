#pragma once

#include <cstddef>

namespace cookbook {

/** Tells memory that `bytes` from `place` on will be wanted soon: pairs lie about as they
 met, and no processor foretells where the next one is. */
inline void Prefetch(const void* place, std::size_t bytes) {
  for (std::size_t k = 0; k < bytes; k += 64) {
    __builtin_prefetch(static_cast<const char*>(place) + k);
  }
}

}  // namespace cookbook
