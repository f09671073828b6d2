#pragma once

#include <cstddef>

namespace cookbook {

/** Prefetches `bytes` starting at `address`. Pairs are visited in random memory order,
 which the hardware prefetcher cannot predict. */
inline void Prefetch(const void* address, std::size_t bytes) {
  for (std::size_t k = 0; k < bytes; k += 64) {
    __builtin_prefetch(static_cast<const char*>(address) + k);
  }
}

}  // namespace cookbook
