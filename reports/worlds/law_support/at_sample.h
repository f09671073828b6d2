#pragma once

#include <cstddef>
#include <string_view>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {

/** A body or particle at one sample of a motion, for comparison with its true state. */
struct AtSample {
  const Motion& motion;
  std::size_t sample;
  std::string_view name;  ///< Name of the body or particle.

  /** Takes the error |is − truth|. `worst` says whether the vectors are positions,
   velocities or spins. Its proof reads "bullet has ball moving at … after 0.5 s; v₀ + a t
   is …", where `truth_is` is "v₀ + a t is". */
  void Compare(Worst& worst, const Eigen::Vector3d& is, const Eigen::Vector3d& truth,
               double tolerance, std::string_view truth_is) const;
};

}  // namespace touchstone
