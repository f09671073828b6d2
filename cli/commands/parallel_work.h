#pragma once

#include <cstddef>
#include <functional>

#include "cli/terminal.h"

namespace touchstone {

/** How a command does many pieces of work. */
struct ParallelWork {
  const Terminal& terminal;
  bool quiet = false;                    ///< No progress bar.
  int jobs = 0;                          ///< Threads; 0: one a processor.
  std::function<bool()> stop = nullptr;  ///< Returns whether no further piece is begun.
};

/** Calls `piece(i)` for each of `count` pieces, in several threads, with a progress bar.
 Returns the number of pieces that were left out. */
std::size_t ForEachInParallel(const ParallelWork& work, std::size_t count,
                              const std::function<void(std::size_t)>& piece);

}  // namespace touchstone
