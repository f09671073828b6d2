#pragma once

#include <cstddef>
#include <functional>

namespace touchstone {

/** Calls `work(i)` for every i in [0, count) from `jobs` threads, 0 meaning one per core.
 Returns when all are done. What `work` writes must belong to its own i, so that the
 outcome does not depend on the number of threads.
 @pre `work` does not throw. */
void ParallelFor(std::size_t count, int jobs,
                 const std::function<void(std::size_t)>& work);

}  // namespace touchstone
