#pragma once

#include <cstddef>
#include <functional>

namespace touchstone {

/** Calls `work(i)` for every i in [0, count) from `jobs` threads, 0 meaning one per core,
 and returns when all calls are done. Each call may write only to data of its own i, so
 that the result does not depend on the number of threads. Each call runs in
 StandardArithmetic, whatever the caller's thread or an earlier call has set.
 @pre `work` does not throw. */
void ParallelFor(std::size_t count, int jobs,
                 const std::function<void(std::size_t)>& work);

}  // namespace touchstone
