#pragma once

#include <functional>

namespace touchstone {

/** Returns whether to stop, and from then on always. Called from any thread; may be
 empty. */
using Stop = std::function<bool()>;

inline bool IsStopped(const Stop& stop) {
  return stop && stop();
}

}  // namespace touchstone
