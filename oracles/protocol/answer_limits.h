#pragma once

#include <chrono>
#include <cstddef>

namespace touchstone {

/** How much a program may use for one answer. */
struct AnswerLimits {
  std::chrono::milliseconds cpu;   ///< CPU time of its process group.
  std::chrono::milliseconds wall;  ///< Time by the clock on the wall.
  std::size_t line;                ///< Longest line, and longest frame. [bytes]
};

}  // namespace touchstone
