#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace touchstone {

/** Returns the indices of the samples that a report keeps of a motion, rising: every
 n-th; the first after the start, which shows what the first step has done; the last, and
 that of each motion that ends earlier, so that a motion that diverges is shown to its
 end; and the last before and the first at or after each
 of `moments` [s], so that what a proof is about is seen. At most eight moments count, the
 earliest.
 @param times Times of all samples [s], rising.
 @param lengths Number of samples of each motion, at most times.size(). */
std::vector<std::size_t> KeptSamples(std::span<const double> times, std::size_t n,
                                     std::vector<double> moments,
                                     std::span<const std::size_t> lengths);

}  // namespace touchstone
