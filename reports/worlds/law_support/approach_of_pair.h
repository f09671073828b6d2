#pragma once

#include <cstddef>
#include <vector>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/overlap.h"

namespace touchstone {

/** How bodies that penetrate each other have approached, no faster than the truth allows
 (AllowedMotion). */
class ApproachOfPair {
 public:
  explicit ApproachOfPair(const Motion& motion);

  /** Returns how fast two bodies may have approached along the normal from sample `s` − 1
   to sample `s`, at which they penetrate each other as `overlap` says. The sum of both:
   an impact may stop one of two bodies that move together. [m/s] */
  double SpeedOf(std::size_t s, int A, int B, const DeepestOverlap& overlap) const;

  /** Returns how much deeper the deepest point is than at sample `s` − 1. [m] */
  double DeepenedBy(std::size_t s, int A, int B, const DeepestOverlap& overlap) const;

  /** Returns whether either body may have touched a third one between samples `s` − 1 and
   `s`, unseen by them. */
  bool MayHaveTouchedThird(std::size_t s, int A, int B) const;

 private:
  double SpeedOfBody(std::size_t s, int body, const DeepestOverlap& overlap) const;

  Motion motion_;
  AllowedMotion slowed_;
  /** Whether a body may touch several others before a sample, indexed by sample and body;
   empty if every step is sampled. */
  std::vector<std::vector<bool>> touches_several_;
};

}  // namespace touchstone
