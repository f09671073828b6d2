#pragma once

#include <cstddef>
#include <mutex>

#include <sys/types.h>

#include "oracles/isolation/unique_fd.h"
#include "oracles/trajectory.h"

namespace touchstone {

/** Keeps motions outside the memory of this process, in an unnamed file that never
 reaches a disk. A fork copies the tables of all pages of the process that forks: children
 that simulate for milliseconds would spend most of their time on the motions of worlds
 that have long been judged. */
class MotionStore {
 public:
  /** The place of a motion in the store. */
  struct Place {
    off_t begin = 0;
    std::size_t size = 0;
  };

  /** @throws std::system_error if the system provides no file. */
  MotionStore();

  /** Keeps a motion bit for bit. May be called from any thread.
   @throws std::system_error if there is no memory for it. */
  Place Keep(const Trajectory& motion);

  /** Returns a motion and frees its place. A motion can be taken once.
   @throws std::system_error if it cannot be read. */
  Trajectory Take(const Place& place);

 private:
  UniqueFd file_;
  std::mutex mutex_;
  off_t end_ = 0;  // Guarded by mutex_.
};

}  // namespace touchstone
