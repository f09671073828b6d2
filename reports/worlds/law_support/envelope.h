#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reports/worlds/law_support/error_laws.h"

namespace touchstone {

/** The distance between two states. */
struct Apart {
  double place = 0;  ///< Of positions [m] or orientations [rad].
  double speed = 0;  ///< Of velocities [m/s] or spins [rad/s].

  void TakeLarger(const Apart& other) {
    place = std::max(place, other.place);
    speed = std::max(speed, other.speed);
  }
};

/** The largest error so far, at each sample of a motion, of legal schemes that are
 stepped next to the truth. */
class Envelope {
 public:
  /** For the first `samples` of the motion. */
  Envelope(const Motion& motion, std::size_t samples)
      : motion_(motion), largest_(samples) {}

  explicit Envelope(const Motion& motion)
      : Envelope(motion, motion.trajectory.samples.size()) {}

  /** Includes a scheme. `step()` advances it by a step; `off(s)` returns how far it is
   from the truth at sample `s`, when it has come there. */
  template <typename Step, typename Off>
  void Include(Step&& step, Off&& off) {
    Apart so_far;
    long done = 0;
    for (std::size_t s = 0; s < largest_.size(); ++s) {
      for (; done < WholeStepsBefore(motion_, s); ++done) step();
      so_far.TakeLarger(off(s));
      largest_[s].TakeLarger(so_far);
    }
  }

  const Apart& At(std::size_t s) const { return largest_[s]; }

 private:
  const Motion& motion_;
  std::vector<Apart> largest_;
};

}  // namespace touchstone
