#pragma once

#include "engine/dynamics/body/settings.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** Arguments that all phases of a time step share. */
struct StepContext {
  const Settings& settings;
  double h;          ///< Time step. [s]
  ThreadPool& pool;  ///< Runs the parallel loops of the step.
};

}  // namespace cookbook
